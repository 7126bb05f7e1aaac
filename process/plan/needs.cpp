#include "process/plan/needs.h"

#include <algorithm>
#include <cmath>

#include "engine/limits/time_step.h"
#include "process/machine/force_control.h"
#include "process/plan/setting.h"
#include "process/powder/changed_scene.h"
#include "process/powder/empty_annulus.h"
#include "process/powder/material.h"
#include "process/setup/impact_speed.h"

namespace diefill::process::plan {

namespace {

constexpr double kSymmetryOverRadius = 0.2;  // as `diefill check` has it

/// Pa: weight of the powder over the deepest place under the largest gravity of any step, as if no wall
/// carried any of it.
double weight_pressure(const Scene& scene, const Tooling& tooling, const engine::GrainShape& shape) {
  const double depth =
      scene.pour.fill_height + (tooling.cavity.found ? tooling.all_cavities().box.size()[2] : 0);
  return shape.mass / shape.solid_volume * expected_solid_fraction(scene) * largest_gravity(scene) * depth;
}

/// Pa: of the force-controlled tool that presses hardest, its force over the area it presses with.
double piston_pressure(const Scene& scene, const Tooling& tooling) {
  double hardest = 0;
  for (const auto& step : scene.steps) {
    const ForceControl* control = step->control();
    if (control == nullptr || control->turns) continue;
    double area = 0;
    for (const auto& name : step->tools())
      area += facing_area(tooling.tools[tooling.index_of(name)].mesh, control->axis.direction);
    if (area > 0) hardest = std::max(hardest, control->largest_target() / area);
  }
  return hardest;
}

}  // namespace

double facing_area(const geometry::Mesh& mesh, const Eigen::Vector3d& direction) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[triangle[0]], b = mesh.vertices[triangle[1]],
                          c = mesh.vertices[triangle[2]];
    area += std::max(0.0, 0.5 * (b - a).cross(c - a).dot(direction));
  }
  return area;
}

Needs needs_of(const Scene& scene, const Tooling& tooling) {
  Needs needs;
  needs.cavity = tooling.all_cavities();
  needs.grain_diameter = scene.powder.grain_diameter;
  needs.calibrated_diameter = calibrated_diameter(scene.powder);
  if (needs.cavity.found && needs.cavity.narrowest_width > 0) {
    needs.coarsest_grain = kCoarsestToDecide * needs.cavity.narrowest_width;
    needs.effective_width =
        needs.cavity.narrowest_width - kEmptyAnnulus * (needs.grain_diameter - needs.calibrated_diameter);
  }
  needs.impact_speed = predicted_impact_speed(scene, tooling);
  const auto settings = engine_settings(scene, needs.impact_speed);
  needs.time_step = settings.time_step;
  needs.critical_step = critical_time_step(settings, needs.impact_speed);
  needs.wedged_step = wedged_time_step(scene, settings);
  needs.weight_pressure = weight_pressure(scene, tooling, mean_grain(scene));
  needs.piston_pressure = piston_pressure(scene, tooling);
  needs.modulus = scene.powder.reduced_modulus;
  needs.least_modulus = kModulusOverPressure * (needs.weight_pressure + needs.piston_pressure);
  needs.damping_over_radius = scene.powder.damping_over_radius;
  needs.fill_height = scene.pour.fill_height;
  const double tolerance = kSymmetryOverRadius * scene.walls.sphere_radius;
  std::vector<geometry::Symmetry> symmetry;
  for (const Tool& tool : tooling.tools) symmetry.push_back(geometry::find_symmetry(tool.solid(), tolerance));
  needs.planes = common_planes(scene, tooling, symmetry, tolerance);
  needs.laws = law_terms(scene, settings);
  return needs;
}

}  // namespace diefill::process::plan
