#include "process/setup/setup_findings.h"

#include <algorithm>
#include <cstdio>

#include "process/machine/actions/powder_inflow.h"
#include "process/machine/free_motion.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/scene/powder/powder_file.h"
#include "process/tooling/examination/plan_view.h"
#include "process/tooling/half_model.h"
#include "process/tooling/stages.h"
#include "process/tooling/tool_paths.h"

namespace diefill::process {

namespace {

constexpr int kCells = 16;            // each way, of the pour box
constexpr double kFewOutside = 0.02;  // share of the pour box
constexpr double kFewGrains = 50;     // in a full cavity
constexpr double kNearPunch = 5e-4;   // m
constexpr double kTooLittle = 0.95;   // powder poured over the cavity's volume

bool has_shoe(const Scene& scene) {
  return std::any_of(scene.tools.begin(), scene.tools.end(),
                     [](const ToolSpec& tool) { return tool.role == ToolRole::shoe; });
}

bool shoe_moves(const Scene& scene) {
  const Stages stages(scene);
  return std::any_of(scene.tools.begin(), scene.tools.end(), [&](const ToolSpec& tool) {
    return tool.role == ToolRole::shoe && stages.moves(tool.name);
  });
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

void find_spilt_pour(const Scene& scene, const Tooling& tooling, std::vector<SetupFinding>& findings) {
  const PourSpec& pour = scene.pour;
  const Eigen::Vector3d size = pour.upper - pour.lower;
  if (!has_shoe(scene) || !(size.minCoeff() > 0)) return;
  const double z = pour.lower.z() + 0.5 * std::min(size.z(), std::max(pour.fill_height, 0.0));
  std::vector<PlanView> views;
  for (const Tool& tool : tooling.tools) views.emplace_back(tool.mesh, z);
  std::vector<Eigen::Vector3d> outside;
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      const Eigen::Vector3d place =
          pour.lower + size.cwiseProduct(Eigen::Vector3d((i + 0.487) / kCells, (j + 0.513) / kCells, 0));
      if (!held(views, scene, place.head<2>())) outside.emplace_back(place.x(), place.y(), z);
    }
  const double share = static_cast<double>(outside.size()) / (kCells * kCells);
  if (share <= kFewOutside) return;
  const Eigen::Vector3d lower = 1e3 * pour.lower, upper = 1e3 * pour.upper;
  char text[300];
  std::snprintf(text, sizeof text,
                "%.0f %% of the pour box (x %.4g to %.4g mm, y %.4g to %.4g mm) lies outside the shoe, where "
                "no walls hold the powder: it will flow away; move the box into the shoe",
                100 * share, lower.x(), upper.x(), lower.y(), upper.y());
  findings.push_back({text, outside});
}

void find_misplaced_punch(const Tooling& tooling, std::vector<SetupFinding>& findings) {
  const geometry::Box cavity = tooling.all_cavities().box;
  for (const Tool& tool : tooling.tools) {
    if (tool.spec.role != ToolRole::punch) continue;
    const geometry::Box punch = tool.mesh.bounding_box();
    const bool beside = (punch.lower.head<2>().array() > cavity.upper.head<2>().array() + kNearPunch).any() ||
                        (punch.upper.head<2>().array() < cavity.lower.head<2>().array() - kNearPunch).any();
    if (!beside) continue;
    char text[300];
    std::snprintf(
        text, sizeof text,
        "punch \"%s\" is beside the cavity (punch: x %.4g to %.4g mm, y %.4g to %.4g mm; cavity: x %.4g "
        "to %.4g mm, y %.4g to %.4g mm); check its position",
        tool.spec.name.c_str(), 1e3 * punch.lower.x(), 1e3 * punch.upper.x(), 1e3 * punch.lower.y(),
        1e3 * punch.upper.y(), 1e3 * cavity.lower.x(), 1e3 * cavity.upper.x(), 1e3 * cavity.lower.y(),
        1e3 * cavity.upper.y());
    findings.push_back({text, {0.5 * (punch.lower + punch.upper)}});
  }
}

/// m^3 of powder at rest, or infinity where a step lets in powder without limit. In a half model [pour] is
/// half of the powder, and the mass of an inflow is that of both halves.
double bulk_of_powder(const Scene& scene, const Tooling& tooling, double solid_fraction, double density) {
  const Eigen::Vector3d size = scene.pour.upper - scene.pour.lower;
  double bulk = copies(tooling) * size.x() * size.y() * scene.pour.fill_height;
  for (const auto& step : scene.steps)
    if (const PowderInflow* inflow = step->inflow())
      bulk += inflow->mass.value_or(1e6) / (solid_fraction * density);
  return bulk;
}

void find_little_powder(const Scene& scene, const Tooling& tooling, std::vector<SetupFinding>& findings) {
  const auto settings = engine_settings(scene, 1.0);
  const double fraction = scene.pour.solid_fraction > 0 ? scene.pour.solid_fraction : 0.35;
  const double cavity = tooling.all_cavities().volume;
  const double grains = cavity * fraction / mean_of_poured(scene).solid_volume;
  char text[300];
  if (grains < kFewGrains) {
    std::snprintf(text, sizeof text,
                  "the full cavity holds about %.0f model grains, fewer than %.0f: too few for reliable "
                  "figures; use a smaller grain_diameter (now %.3g mm)",
                  grains, kFewGrains, 1e3 * scene.powder.grain_diameter);
    findings.push_back({text, {}});
  }
  const auto grain = mean_of_poured(scene);
  const double bulk = bulk_of_powder(scene, tooling, fraction, grain.mass / grain.solid_volume);
  if (!shoe_moves(scene) || bulk > kTooLittle * cavity) return;
  std::snprintf(
      text, sizeof text,
      "%.3g cm3 of powder are poured, %.0f %% of the cavity's %.3g cm3: not enough to fill it; raise "
      "pour.fill_height",
      1e6 * bulk, 100 * bulk / cavity, 1e6 * cavity);
  findings.push_back({text, {}});
}

void find_forced_collisions(const Scene& scene, const Tooling& tooling, std::vector<SetupFinding>& findings) {
  const bool forced = std::any_of(scene.steps.begin(), scene.steps.end(), [](const auto& step) {
    return step->control() != nullptr || free_motion_of(*step) != nullptr;
  });
  if (!forced) return;
  for (const auto& collision : find_collisions(scene, tooling, ForcedTools::full_travel))
    findings.push_back({"without powder to stop it, " + collision.description() +
                            "; the run stops if this happens: reduce its travel",
                        {collision.place}});
}

}  // namespace

std::vector<SetupFinding> setup_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  find_spilt_pour(scene, tooling, findings);
  if (tooling.cavity.found) {
    for (auto& finding : shoe_findings(scene, tooling)) findings.push_back(std::move(finding));
    find_misplaced_punch(tooling, findings);
    find_little_powder(scene, tooling, findings);
  }
  for (auto& finding : inflow_findings(scene, tooling)) findings.push_back(std::move(finding));
  find_forced_collisions(scene, tooling, findings);
  for (auto& finding : measure_findings(scene, tooling)) findings.push_back(std::move(finding));
  for (auto& finding : suction_findings(scene)) findings.push_back(std::move(finding));
  if (std::string other = fitted_with_warning(scene); !other.empty())
    findings.push_back({std::move(other), {}});
  return findings;
}

}  // namespace diefill::process
