#include "process/setup/setup_findings.h"

#include <algorithm>
#include <cstdio>

#include "process/machine/actions/powder_inflow.h"
#include "process/machine/free_motion.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/scene/powder/powder_file.h"
#include "process/setup/unreachable_mass.h"
#include "process/tooling/half_model.h"
#include "process/tooling/stages.h"
#include "process/tooling/tool_paths.h"

namespace diefill::process {

namespace {

constexpr double kFewGrains = 50;    // in a full cavity
constexpr double kNearPunch = 5e-4;  // m
constexpr double kTooLittle = 0.95;  // powder poured over the cavity's volume

bool shoe_moves(const Scene& scene) {
  const Stages stages(scene);
  return std::any_of(scene.tools.begin(), scene.tools.end(), [&](const ToolSpec& tool) {
    return tool.role == ToolRole::shoe && stages.moves(tool.name);
  });
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
  const double fraction = expected_solid_fraction(scene);
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
  const auto add = [&](std::vector<SetupFinding> more) {
    for (auto& finding : more) findings.push_back(std::move(finding));
  };
  refuse_unreachable_mass(scene, tooling);
  add(pour_findings(scene, tooling));
  add(shoe_floor_findings(scene, tooling));
  if (tooling.cavity.found) {
    add(shoe_findings(scene, tooling));
    add(table_findings(scene, tooling));
    add(cavity_findings(scene, tooling));
    find_misplaced_punch(tooling, findings);
    find_little_powder(scene, tooling, findings);
  }
  add(inflow_findings(scene, tooling));
  find_forced_collisions(scene, tooling, findings);
  add(measure_findings(scene, tooling));
  add(suction_findings(scene));
  if (std::string other = fitted_with_warning(scene); !other.empty())
    findings.push_back({std::move(other), {}});
  return findings;
}

}  // namespace diefill::process
