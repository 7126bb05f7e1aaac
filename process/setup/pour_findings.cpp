// Whether walls hold the powder that is poured.
#include <algorithm>
#include <array>

#include "process/results/formatted.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/examination/plan_view.h"

namespace diefill::process {

namespace {

constexpr int kCells = 16;            // each way, of the pour box
constexpr double kFewOutside = 0.02;  // share of the pour box
constexpr double kLow = 0.1;          // of the powder's depth, over the floor of the pour box

bool has_shoe(const Scene& scene) {
  return std::any_of(scene.tools.begin(), scene.tools.end(),
                     [](const ToolSpec& tool) { return tool.role == ToolRole::shoe; });
}

/// Walls on at least three sides, of any tools together, or a period: powder there stays.
bool held(const std::vector<PlanView>& views, const Scene& scene, const Eigen::Vector2d& place) {
  std::array<bool, 4> walls = {};
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (scene.numerics.period[axis]) walls[2 * axis] = walls[2 * axis + 1] = true;
  for (const PlanView& view : views) {
    const auto beside = view.walls_beside(place);
    for (std::size_t side = 0; side < 4; ++side) walls[side] = walls[side] || beside[side];
  }
  return std::count(walls.begin(), walls.end(), true) >= 3;
}

/// Places of the pour box that no walls hold at height `z`, m.
std::vector<Eigen::Vector3d> loose_places(const Scene& scene, const Tooling& tooling, double z) {
  std::vector<PlanView> views;
  for (const Tool& tool : tooling.tools) views.emplace_back(tool.mesh, z);
  const Eigen::Vector3d lower = scene.pour.lower, size = scene.pour.upper - lower;
  std::vector<Eigen::Vector3d> loose;
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      const Eigen::Vector3d place =
          lower + size.cwiseProduct(Eigen::Vector3d((i + 0.487) / kCells, (j + 0.513) / kCells, 0));
      if (!held(views, scene, place.head<2>())) loose.emplace_back(place.x(), place.y(), z);
    }
  return loose;
}

double share_of_box(const std::vector<Eigen::Vector3d>& places) {
  return static_cast<double>(places.size()) / (kCells * kCells);
}

SetupFinding outside(const PourSpec& pour, std::vector<Eigen::Vector3d> places) {
  const Eigen::Vector3d lower = 1e3 * pour.lower, upper = 1e3 * pour.upper;
  return {results::formatted(
              "%.0f %% of the pour box (x %.4g to %.4g mm, y %.4g to %.4g mm) lies outside the shoe, where "
              "no walls hold the powder: it will flow away; move the box into the shoe",
              100 * share_of_box(places), lower.x(), upper.x(), lower.y(), upper.y()),
          std::move(places)};
}

/// m, z up to which walls hold the powder that they hold at `low` and do not hold at `high`.
double rim(const Scene& scene, const Tooling& tooling, double low, double high) {
  constexpr double kExact = 1e-6;  // m
  while (high - low > kExact) {
    const double middle = 0.5 * (low + high);
    (share_of_box(loose_places(scene, tooling, middle)) > kFewOutside ? high : low) = middle;
  }
  return low;
}

SetupFinding over_the_rim(const Scene& scene, double top, double rim, std::vector<Eigen::Vector3d> places) {
  const double floor = scene.pour.lower.z();
  return {
      results::formatted(
          "powder is poured up to z = %.4g mm (pour.from plus fill_height), and the walls around it end at z "
          "= %.4g mm: what stands %.3g mm above them runs over the rim; lower pour.fill_height to %.4g mm or "
          "less, or use a shoe with higher walls",
          1e3 * top, 1e3 * rim, 1e3 * (top - rim), 1e3 * (rim - floor)),
      std::move(places)};
}

}  // namespace

std::vector<SetupFinding> pour_findings(const Scene& scene, const Tooling& tooling) {
  const PourSpec& pour = scene.pour;
  const Eigen::Vector3d size = pour.upper - pour.lower;
  const double depth = std::min(size.z(), std::max(pour.fill_height, 0.0)), floor = pour.lower.z();
  if (!has_shoe(scene) || !(size.minCoeff() > 0) || !(depth > 0)) return {};
  const double middle = floor + 0.5 * depth, top = floor + depth;
  auto places = loose_places(scene, tooling, middle);
  double walled = middle;  // m, z at which walls hold the powder
  if (share_of_box(places) > kFewOutside) {
    walled = floor + kLow * depth;
    if (share_of_box(loose_places(scene, tooling, walled)) > kFewOutside)
      return {outside(pour, std::move(places))};
  }
  // The uppermost layer of grains may look over the rim.
  const double surface = std::max(walled, top - 0.5 * scene.powder.grain_diameter);
  places = loose_places(scene, tooling, surface);
  if (share_of_box(places) <= kFewOutside) return {};
  return {over_the_rim(scene, top, rim(scene, tooling, walled, surface), std::move(places))};
}

}  // namespace diefill::process
