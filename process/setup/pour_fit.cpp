#include "process/setup/pour_fit.h"

#include <algorithm>
#include <cstdio>

#include "geometry/solid/solid_query.h"

namespace diefill::process {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& why) {
  throw SceneError(scene.file.string() + ":" + std::to_string(scene.pour.line) + ": pour: " + why);
}

/// m, from the box's floor to the highest grain's centre.
double height_of(const std::vector<engine::NewGrain>& grains, const Scene& scene) {
  double highest = scene.pour.lower[2];
  for (const auto& grain : grains) highest = std::max(highest, grain.position[2]);
  return highest - scene.pour.lower[2];
}

/// What to do about a tool that only the loose lattice meets; `share` of the powder fits.
std::string advice(const Scene& scene, const std::vector<engine::NewGrain>& grains, double share) {
  char text[320];
  std::snprintf(text, sizeof text,
                "; powder is poured loosely, %.3g mm high, and settles to %.3g mm: pour at most %.3g mm here "
                "(fill_height, or the height of the box if a setting is used), open the top of the tool, or "
                "feed powder with a step of kind \"inflow\"",
                1e3 * height_of(grains, scene), 1e3 * scene.pour.fill_height,
                1e3 * share * scene.pour.fill_height);
  return text;
}

/// The tool nearest to a place (m).
const Tool& tool_at(const Tooling& tooling, const Eigen::Vector3d& place) {
  return *std::min_element(tooling.tools.begin(), tooling.tools.end(),
                           [&](const Tool& one, const Tool& other) {
                             return one.solid().signed_distance(place) < other.solid().signed_distance(place);
                           });
}

}  // namespace

void refuse_powder_over_nothing(const Scene& scene, const geometry::Box& standing) {
  static const char* const kAxes[] = {"x", "y", "z"};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (scene.numerics.period[static_cast<std::size_t>(axis)]) continue;
    const double from = scene.pour.lower[axis], to = scene.pour.upper[axis];
    const double lower = standing.lower[axis],
                 upper = axis < 2 ? standing.upper[axis] : std::max(to, standing.upper[2]);
    if (from >= lower && to <= upper) continue;
    char text[240];
    std::snprintf(text, sizeof text,
                  "the box reaches from %.4g to %.4g mm along %s, but the fixed tools only from %.4g to %.4g "
                  "mm: powder outside would be lost; move the box or the tools",
                  1e3 * from, 1e3 * to, kAxes[axis], 1e3 * lower, 1e3 * upper);
    refuse(scene, text);
  }
}

void refuse_beyond_period(const Scene& scene, const std::vector<engine::NewGrain>& grains, double radius) {
  const auto& period = scene.numerics.period[2];
  if (!period) return;
  double highest = -0.5 * *period;
  for (const auto& grain : grains) highest = std::max(highest, grain.position[2]);
  if (highest + radius <= 0.5 * *period) return;
  char text[240];
  std::snprintf(
      text, sizeof text,
      "loosely poured, the powder reaches %.4g mm, beyond the period along z, which ends at %.4g mm; "
      "reduce fill_height or lattice_constant",
      1e3 * (highest + radius), 0.5e3 * *period);
  refuse(scene, text);
}

void refuse_overlap(const Scene& scene, const Tooling& tooling, const std::vector<engine::NewGrain>& grains,
                    const std::vector<double>& radii) {
  for (const Tool& tool : tooling.tools) {
    const geometry::SolidQuery& solid = tool.solid();
    for (const auto& grain : grains) {
      const double radius = radii[grain.kind];
      const double distance = solid.signed_distance(grain.position);
      if (distance > kNearestTool * radius) continue;
      char text[240];
      std::snprintf(text, sizeof text,
                    "tool \"%s\" reaches %.3g mm into the powder near (%.2f, %.2f, %.2f) mm",
                    tool.spec.name.c_str(), 1e3 * (radius - distance), 1e3 * grain.position[0],
                    1e3 * grain.position[1], 1e3 * grain.position[2]);
      if (scene.pour.grains_file)
        refuse(scene, text + std::string("; move the tool, or that grain in grains_file"));
      const double height = grain.position[2] - scene.pour.lower[2];
      refuse(scene, text + (height > scene.pour.fill_height + radius
                                ? advice(scene, grains, (height - 2 * radius) / height_of(grains, scene))
                                : "; move the pour box or the tool so that they do not overlap, or set "
                                  "around_tools = true"));
    }
  }
}

void refuse_lid(const Scene& scene, const Tooling& tooling, const std::vector<engine::NewGrain>& grains,
                double layer) {
  constexpr double kOneLayerMissing = 1.5;
  std::vector<Eigen::Vector3d> places;
  for (const auto& grain : grains) places.push_back(grain.position);
  std::sort(places.begin(), places.end(),
            [](const auto& one, const auto& other) { return one[2] < other[2]; });
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (places[k + 1][2] - places[k][2] < kOneLayerMissing * layer) continue;
    const Tool& lid = tool_at(tooling, 0.5 * (places[k] + places[k + 1]));
    char text[240];
    std::snprintf(text, sizeof text, "only %zu of %zu grains fit below tool \"%s\", which closes the box",
                  k + 1, places.size(), lid.spec.name.c_str());
    refuse(scene,
           text + advice(scene, grains, static_cast<double>(k + 1) / static_cast<double>(places.size())));
  }
}

}  // namespace diefill::process
