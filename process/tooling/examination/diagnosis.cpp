#include "process/tooling/examination/diagnosis.h"

#include <algorithm>
#include <iterator>

#include "geometry/grids/all_cores.h"
#include "geometry/grids/point_grid.h"
#include "process/results/formatted.h"
#include "process/tooling/examination/tool_fit.h"

namespace diefill::process {

namespace {

constexpr double kReachOverDiameter = 3;  // wider gaps are openings, not clearances of neighbours
constexpr double kMinReach = 1e-3;        // m
constexpr double kSampleSpacing = 5e-4;   // m
constexpr double kSymmetryOverRadius = 0.2;
constexpr double kNothing = 1e-6;  // m, what rounding in CAD files makes of zero

std::string near(const Eigen::Vector3d& place) {
  return results::formatted(" near (%.2f, %.2f, %.2f) mm", 1e3 * place[0], 1e3 * place[1], 1e3 * place[2]);
}

std::string millimetres(double length) {
  return results::formatted("%.3g mm", 1e3 * length);
}

/// The parts of a tool's surface that powder can touch: they are covered with wall spheres.
class PowderSide {
 public:
  explicit PowderSide(const Tool& tool)
      : reach_(kReachOverSphere * tool.spheres.radius), spheres_(std::max(reach_, kNothing)) {
    spheres_.reserve(tool.spheres.centres.size());
    for (const auto& centre : tool.spheres.centres) spheres_.insert(centre);
  }
  bool has(const Eigen::Vector3d& point) const { return spheres_.any_within(point, reach_); }

 private:
  static constexpr double kReachOverSphere = 2.2;  // they lie one radius deep, and stand close
  double reach_;
  geometry::PointGrid spheres_;
};

/// What the tools of a scene are asked about when pairs of them are looked at.
struct Surroundings {
  const Scene& scene;
  const Tooling& tooling;
  std::vector<PowderSide> powder_side;  ///< of each tool
  double sphere_radius;                 ///< m, of the powder's smallest sphere
};

bool lies_in(const geometry::Cavity& cavity, const Tooling& tooling, const Eigen::Vector3d& place) {
  return cavity.found && cavity.box.contains(place) && place.z() > cavity.box.lower.z() + kNothing &&
         place.z() < tooling.fill_plane - kNothing;
}

/// Inside a cavity or the poured powder, or where a third tool fills the space between two.
bool elsewhere(const Surroundings& around, std::size_t one, std::size_t other, const Eigen::Vector3d& place) {
  const Tooling& tooling = around.tooling;
  if (geometry::Box{around.scene.pour.lower, around.scene.pour.upper}.contains(place)) return true;
  for (std::size_t third = 0; third < tooling.tools.size(); ++third)
    if (third != one && third != other && tooling.tools[third].solid().inside(place)) return true;
  const auto within = [&](const geometry::Cavity& cavity) { return lies_in(cavity, tooling, place); };
  return within(tooling.cavity) || std::ranges::any_of(tooling.other_cavities, within);
}

/// The gap seen from one of the tools, as far as powder can come.
geometry::Gap gap_seen_from(const Surroundings& around, std::size_t one, std::size_t other) {
  const double reach = std::max(kMinReach, kReachOverDiameter * around.scene.powder.grain_diameter);
  return geometry::measure_gap(
      around.tooling.tools[one].solid(), around.tooling.tools[other].solid(), reach, kSampleSpacing,
      [&](const Eigen::Vector3d& point, const Eigen::Vector3d& halfway) {
        return !around.powder_side[one].has(point) || elsewhere(around, one, other, halfway);
      });
}

geometry::Gap gap_between(const Surroundings& around, std::size_t one, std::size_t other) {
  geometry::Gap gap = gap_seen_from(around, one, other);
  const geometry::Gap back = gap_seen_from(around, other, one);
  if (!gap.found) return back;
  if (!back.found) return gap;
  const double narrowest = std::min(gap.narrowest, back.narrowest);
  if (back.widest > gap.widest) gap = back;
  gap.narrowest = narrowest;
  return gap;
}

std::string description(const PairDiagnosis& pair, const Scene& scene, double sphere_radius) {
  std::string text;
  if (pair.overlap > kNothing)
    text = "overlap by " + millimetres(pair.overlap) + near(pair.overlap_place) + " (interference fit)";
  if (!pair.gap.found) return text;
  if (!text.empty()) text += "; ";
  if (pair.gap.widest <= kNothing) return text + "in contact without a gap";
  const std::string narrowest = millimetres(pair.gap.narrowest), widest = millimetres(pair.gap.widest);
  text += "gap of " + (narrowest == widest ? widest : narrowest + " to " + widest);
  if (pair.powder_enters)
    return text + near(pair.gap.widest_place) + ": powder enters (spheres of " +
           millimetres(2 * sphere_radius) + ")";
  if (pair.real_powder_enters)
    return text + near(pair.gap.widest_place) +
           ": closed to the model grains, but the real powder (spheres of " +
           millimetres(2 * scene.powder.sphere_radius) + ") may enter";
  return text + ": closed to the powder";
}

PairDiagnosis pair_of(const Surroundings& around, std::size_t one, std::size_t other) {
  const Tool &first = around.tooling.tools[one], &second = around.tooling.tools[other];
  PairDiagnosis pair;
  pair.one = first.spec.name;
  pair.other = second.spec.name;
  const geometry::Penetration overlap = deepest_overlap(first, second, around.sphere_radius);
  pair.overlap = overlap.depth;
  pair.overlap_place = overlap.place;
  pair.gap = gap_between(around, one, other);
  pair.powder_enters = pair.gap.found && pair.gap.widest > 2 * around.sphere_radius;
  pair.real_powder_enters = pair.gap.found && pair.gap.widest > 2 * around.scene.powder.sphere_radius;
  pair.description = description(pair, around.scene, around.sphere_radius);
  return pair;
}

}  // namespace

Diagnosis diagnose(const Scene& scene, const Tooling& tooling, double sphere_radius) {
  Diagnosis diagnosis;
  for (const Tool& tool : tooling.tools) tool.solid();  // there before several threads ask for it
  const std::size_t tools = tooling.tools.size();
  const Surroundings around{scene, tooling, {tooling.tools.begin(), tooling.tools.end()}, sphere_radius};
  diagnosis.symmetry.resize(tools);
  std::vector<PairDiagnosis> pairs(tools * (tools - 1) / 2);  // by tool, then by those before it
  geometry::on_all_cores(tools, [&](std::size_t k) {
    const Tool& tool = tooling.tools[k];
    const double radius = tool.spec.sphere_radius.value_or(scene.walls.sphere_radius);
    diagnosis.symmetry[k] = geometry::find_symmetry(tool.solid(), kSymmetryOverRadius * radius);
    for (std::size_t other = 0; other < k; ++other)
      pairs[k * (k - 1) / 2 + other] = pair_of(around, other, k);
  });
  std::ranges::copy_if(pairs, std::back_inserter(diagnosis.pairs),
                       [](const PairDiagnosis& pair) { return !pair.description.empty(); });
  return diagnosis;
}

}  // namespace diefill::process
