#include "process/run/diagnosis.h"

#include <algorithm>
#include <cstdio>

#include "process/run/tool_fit.h"

namespace diefill::process {

namespace {

constexpr double kReachOverDiameter = 3;  // wider than this, two tools are no neighbours but an opening
constexpr double kLeastReach = 1e-3;      // m
constexpr double kSampleSpacing = 5e-4;   // m
constexpr double kSymmetryOverRadius = 0.2;
constexpr double kNothing = 1e-6;  // m, what rounding in CAD files makes of zero

std::string near(const Eigen::Vector3d& place) {
  char text[90];
  std::snprintf(text, sizeof text, " near (%.2f, %.2f, %.2f) mm", 1e3 * place[0], 1e3 * place[1],
                1e3 * place[2]);
  return text;
}

std::string millimetres(double length) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g mm", 1e3 * length);
  return text;
}

bool lies_in(const geometry::Cavity& cavity, const Scene& scene, const Eigen::Vector3d& place) {
  return cavity.found && cavity.box.contains(place) && place.z() > cavity.box.lower.z() + kNothing &&
         place.z() < scene.measure.fill_plane - kNothing;
}

/// Inside a cavity, or where a third tool fills the space between two.
bool elsewhere(const Scene& scene, const Tooling& tooling, const Tool& one, const Tool& other,
               const Eigen::Vector3d& place) {
  for (const Tool& third : tooling.tools)
    if (&third != &one && &third != &other && third.solid().inside(place)) return true;
  const auto within = [&](const geometry::Cavity& cavity) { return lies_in(cavity, scene, place); };
  return within(tooling.cavity) || std::ranges::any_of(tooling.other_cavities, within);
}

geometry::Gap gap_between(const Scene& scene, const Tooling& tooling, const Tool& one, const Tool& other) {
  const double reach = std::max(kLeastReach, kReachOverDiameter * scene.powder.grain_diameter);
  const auto passed_over = [&](const Eigen::Vector3d& place) {
    return elsewhere(scene, tooling, one, other, place);
  };
  geometry::Gap gap = geometry::measure_gap(one.solid(), other.solid(), reach, kSampleSpacing, passed_over);
  const geometry::Gap back =
      geometry::measure_gap(other.solid(), one.solid(), reach, kSampleSpacing, passed_over);
  if (!gap.found) return back;
  if (!back.found) return gap;
  const double narrowest = std::min(gap.narrowest, back.narrowest);
  if (back.widest > gap.widest) gap = back;
  gap.narrowest = narrowest;
  return gap;
}

std::string in_words(const PairDiagnosis& pair, const Scene& scene, double sphere_radius) {
  std::string text;
  if (pair.overlap > kNothing)
    text = "overlap by " + millimetres(pair.overlap) + near(pair.overlap_place) + ", as fits that rub do";
  if (!pair.gap.found) return text;
  if (!text.empty()) text += "; ";
  if (pair.gap.widest <= kNothing) return text + "touch without a gap";
  text += "gap of " + millimetres(pair.gap.narrowest) + " to " + millimetres(pair.gap.widest);
  if (pair.powder_enters)
    return text + near(pair.gap.widest_place) + ": powder enters, its spheres measure " +
           millimetres(2 * sphere_radius);
  if (pair.real_powder_enters)
    return text + near(pair.gap.widest_place) +
           ": closed to the model's grains, but the real powder, whose spheres "
           "measure " +
           millimetres(2 * scene.powder.sphere_radius) + ", may enter";
  return text + ": closed to the powder";
}

PairDiagnosis pair_of(const Scene& scene, const Tooling& tooling, const Tool& one, const Tool& other,
                      double sphere_radius) {
  PairDiagnosis pair;
  pair.one = one.spec.name;
  pair.other = other.spec.name;
  const Overlap overlap = deepest_overlap(one, other);
  pair.overlap = overlap.depth;
  pair.overlap_place = overlap.place;
  pair.gap = gap_between(scene, tooling, one, other);
  pair.powder_enters = pair.gap.found && pair.gap.widest > 2 * sphere_radius;
  pair.real_powder_enters = pair.gap.found && pair.gap.widest > 2 * scene.powder.sphere_radius;
  pair.in_words = in_words(pair, scene, sphere_radius);
  return pair;
}

}  // namespace

Diagnosis diagnose(const Scene& scene, const Tooling& tooling, double sphere_radius) {
  Diagnosis diagnosis;
  for (const Tool& tool : tooling.tools) tool.solid();  // there before several threads ask for it
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    const Tool& tool = tooling.tools[k];
    const double radius = tool.spec.sphere_radius.value_or(scene.walls.sphere_radius);
    diagnosis.symmetry.push_back(geometry::find_symmetry(tool.solid(), kSymmetryOverRadius * radius));
    for (std::size_t other = 0; other < k; ++other) {
      PairDiagnosis pair = pair_of(scene, tooling, tooling.tools[other], tool, sphere_radius);
      if (!pair.in_words.empty()) diagnosis.pairs.push_back(std::move(pair));
    }
  }
  return diagnosis;
}

}  // namespace diefill::process
