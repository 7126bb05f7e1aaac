#include "process/run/assemble.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "process/measure/fields/measured_fields.h"
#include "process/measure/figures/heap_slope.h"
#include "process/measure/figures/zone_history.h"
#include "process/measure/measure.h"
#include "process/results/formatted.h"
#include "process/results/no_value.h"
#include "process/results/storage/hash_text.h"
#include "process/run/figures/margin_warnings.h"
#include "process/run/figures/measure_cavities.h"
#include "process/run/kept_instants.h"
#include "process/run/outcome.h"
#include "process/run/powder_state.h"
#include "process/run/topics.h"
#include "process/scene/zones.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/busy_time.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

#ifndef DIEFILL_VERSION
#error "the build names the program's version in DIEFILL_VERSION"
#endif

namespace diefill::process {

namespace {

results::ToolState tool_state(const Tool& tool, const engine::BodyMotion& motion) {
  results::ToolState state;
  state.name = tool.spec.name;
  state.role = description(tool.spec.role);
  const geometry::Mesh mesh = geometry::transformed(tool.mesh, motion.rotation, motion.translation);
  state.vertices = mesh.vertices;
  state.triangles = mesh.triangles;
  for (const auto& centre : tool.spheres.centres) state.wall_sphere_centres.push_back(motion.point(centre));
  state.wall_sphere_radius = tool.spheres.radius;
  state.mesh_hash = tool.file_hash;
  return state;
}

/// Horizontal direction in which the first tool that travels starts to move; zero when none does.
Eigen::Vector3d first_motion(const Scene& scene) {
  constexpr int kInstants = 100;
  for (const auto& step : scene.steps) {
    if (step->tools().empty() || step->stays() || step->open_ended()) continue;
    for (int n = 1; n < kInstants; ++n) {
      Eigen::Vector3d velocity = step->motion(*step->duration() * n / kInstants).velocity;
      velocity[2] = 0;
      if (velocity.norm() > 0) return velocity.normalized();
    }
  }
  return Eigen::Vector3d::Zero();
}

/// The cavity as it is now: predicted, unless a step ended elsewhere than predicted.
results::CavityState cavity_now(const Scene& scene, const Tooling& tooling, const FillRun& run) {
  constexpr double kAsPredicted = 1e-6;  // m
  std::vector<ToolPose> poses;
  const Stages& stages = run.schedule().stages();
  const auto plan = predicted(stages, kSettlingGuess);
  constexpr double kLongAfter = 1e9;  // s
  double off = 0;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    const engine::BodyMotion& motion = run.simulation().body_motion(k);
    ToolPose pose;
    pose.rotation = motion.rotation;
    pose.translation = motion.translation;
    poses.push_back(pose);
    if (tooling.tools[k].spec.role == ToolRole::shoe) continue;
    const ToolPose planned = pose_of(stages, plan, tooling.tools[k].spec.name, kLongAfter);
    off = std::max(
        {off, (pose.translation - planned.translation).norm(),
         (pose.rotation - planned.rotation).norm() * tooling.tools[k].mesh.bounding_box().size().norm()});
  }
  results::CavityState cavity =
      cavity_state(off > kAsPredicted ? cavity_between(tooling, poses) : tooling.cavity);
  const Eigen::Vector3d direction = first_motion(scene);
  if (direction.norm() > 0) cavity.azimuth_zero = -direction;
  return cavity;
}

/// Where the die has been left away from its place, what that means for the results.
std::vector<std::string> moved_die(const DieFrame& frame, const std::string& name) {
  if (frame.at_initial_pose()) return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "tool \"%s\" ended %.3g mm and %.3g deg from its initial position; all positions in the "
                "results are in its frame",
                name.c_str(), 1e3 * frame.shift(), frame.turn() * 180 / std::numbers::pi);
  return {text};
}

/// Time steps, the times that the scene and the computation took, and speed.
void add_time_figures(results::FillResult& result, const FillRun& run) {
  const engine::Simulation& simulation = run.simulation();
  const auto& settings = simulation.settings();
  auto& figures = result.figures;
  figures["finished"] = run.schedule().finished() ? 1 : 0;
  figures["steps"] = static_cast<double>(simulation.steps());
  figures["time_step_s"] = settings.time_step;
  figures["critical_time_step_s"] = run.critical_time_step();
  figures["cycle_time_s"] = busy_time(run.schedule().stages(), run.schedule().state().steps);
  figures["simulated_s"] = simulation.time();
  figures["wall_seconds"] = run.wall_seconds();
  figures["sphere_steps"] = static_cast<double>(run.sphere_steps());
  figures["sphere_steps_left_out"] = static_cast<double>(engine::sphere_steps_left_out(simulation));
  figures["sphere_steps_per_second"] = static_cast<double>(run.sphere_steps()) / run.wall_seconds();
  figures["threads"] = settings.threads;
  if (run.ranks() > 1) figures["ranks"] = run.ranks();
  for (std::size_t phase = 0; phase < engine::kPhaseNames.size(); ++phase)
    result.phase_seconds[engine::kPhaseNames[phase]] = simulation.timers().seconds()[phase];
}

/// Grains that are no longer there.
void add_loss_figures(results::FillResult& result, const Tooling& tooling, const FillRun& run) {
  auto& figures = result.figures;
  const double left = copies(tooling) * static_cast<double>(run.grains_removed());
  const auto grains = static_cast<double>(result.powder.id.size());
  figures["grains_left"] = left;
  figures["grains_sheared"] = copies(tooling) * static_cast<double>(run.grains_sheared());
  figures["grains_left_share"] = left > 0 ? left / (left + grains + figures["grains_sheared"]) : 0;
  figures["mass_left_kg"] = copies(tooling) * run.mass_removed();
}

void add_figures(const Scene& scene, results::FillResult& result, const Tooling& tooling,
                 const FillRun& run) {
  auto& figures = result.figures;
  figures["filled_mass_kg"] = filled_mass(result.powder, result.solid_fraction);
  figures["grains"] = static_cast<double>(result.powder.id.size());
  figures["spheres"] = static_cast<double>(result.powder.sphere_count());
  figures["wall_spheres"] = static_cast<double>(tooling.wall_spheres());
  add_time_figures(result, run);
  add_margin_figures(result, run);
  add_loss_figures(result, tooling, run);
  figures["grain_diameter_m"] = result.powder.grain_diameter;
  if (!run.simulation().types().monodisperse()) {
    figures["smallest_grain_diameter_m"] = smallest_grain(scene);
    figures["largest_grain_diameter_m"] = largest_grain(scene);
  }
  figures["bulk_solid_fraction"] = bulk_solid_fraction(result.powder, result.solid_fraction);
  if (result.cavity.volume > 0) {
    figures["cavity_volume_m3"] = result.cavity.volume;
    figures["cavity_narrowest_width_m"] = result.cavity.narrowest_width;
    if (result.cavity.narrowest_width > 0)
      figures["grain_diameter_over_cavity_width"] = largest_grain(scene) / result.cavity.narrowest_width;
  }
}

std::vector<results::ToolCheck> tool_checks(const Tooling& tooling) {
  std::vector<results::ToolCheck> checks;
  for (const Tool& tool : tooling.tools)
    checks.push_back({tool.spec.name, tool.spec.file.filename().string(), tool.findings.description(),
                      tool.mesh.volume(), tool.spheres.mean_deviation, tool.spheres.largest_deviation,
                      tool.spheres.largest_gap});
  return checks;
}

std::vector<results::SectionPlane> wanted_sections(const Scene& scene) {
  std::vector<results::SectionPlane> planes;
  for (const auto& section : scene.measure.sections)
    planes.push_back(section_plane(section.name, section.origin, section.normal));
  return planes;
}

/// Suffix to the names of a scene that is not over, so that pages and pictures show it.
std::string unfinished_mark(const FillRun& run) {
  if (!run.ended_early()) return {};
  return results::formatted(" (UNFINISHED, at t = %.4g s)", run.simulation().time());
}

}  // namespace

void add_margin_figures(results::FillResult& result, const FillRun& run) {
  const engine::Simulation& simulation = run.simulation();
  auto& figures = result.figures;
  figures["time_step_fraction"] = simulation.settings().time_step / run.critical_time_step();
  figures["energy_balance_error"] = engine::energy_balance_error(simulation);
  const engine::DeepestOverlap& deepest = simulation.overlaps_of_run();
  figures["deepest_overlap_ratio"] = deepest.grains_over_radius;
  figures["deepest_wall_overlap_ratio"] = deepest.walls_over_radius;
  figures["overlap_limit_ratio"] = engine::ValidityLimits{}.largest_overlap;
  figures["wall_overlap_limit_ratio"] = engine::ValidityLimits{}.largest_wall_overlap;
  figures["energy_error_limit"] = engine::ValidityLimits{}.energy_error;
}

std::string program_version() {
  return DIEFILL_VERSION;
}

results::FillResult powder_and_tools(const Scene& scene, const Tooling& tooling, const FillRun& run) {
  results::FillResult result;
  const std::string mark = unfinished_mark(run);
  result.title = scene.title + mark;
  result.strategy = strategy_text(scene) + mark;
  result.powder_name = powder_names(scene);
  result.scene_text = scene.text;
  result.program_version = program_version();
  result.seed = scene.seed;
  const DieFrame die = die_frame(run.simulation(), tooling);
  result.powder = powder_state(scene, run.simulation());
  add_images(tooling, result.powder);
  result.powder = die.powder(std::move(result.powder));
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    result.tools.push_back(tool_state(tooling.tools[k], die.pose(run.simulation().body_motion(k))));
    add_images(tooling, result.tools.back().wall_sphere_centres);
  }
  result.cavity = cavity_now(scene, tooling, run);
  return result;
}

results::FillResult assemble(const Scene& scene, const Tooling& tooling, const FillRun& run) {
  results::FillResult result = powder_and_tools(scene, tooling, run);
  result.state_hash = results::hash_text(run.simulation().hash());
  const DieFrame die = die_frame(run.simulation(), tooling);
  result.contact_stress = contact_stress(run.simulation(), die);
  add_images(tooling, result.contact_stress);
  result.instants = kept_instants(tooling, run, result.powder);
  result.probes = run.probes();
  result.solid_fraction = measure_solid_fraction(result.powder, result.tools, result.cavity);
  result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
  add_figures(scene, result, tooling, run);
  result.warnings = tooling.remarks();
  for (const auto& warning : run.warnings()) result.warnings.push_back(warning);
  for (auto& warning : moved_die(die, tooling.tools[tooling.die].spec.name))
    result.warnings.push_back(std::move(warning));
  result.tool_checks = tool_checks(tooling);
  result.stages = run.schedule().completed_stages();
  result.topics = topics(scene, run);
  measure_cavities(result, scene, tooling, wanted_sections(scene));
  for (auto& line : margin_warnings(result)) result.warnings.push_back(std::move(line));
  for (const auto& finding : setup_findings(scene, tooling))
    result.warnings.push_back(kAlert + finding.words);
  for (auto& line : outcome_text(scene, result)) result.warnings.push_back(std::move(line));
  for (const HeapSpec& heap : scene.measure.heaps) {
    const double slope = heap_slope(result.powder, heap.from, heap.to);
    if (std::isfinite(slope))
      result.figures[heap_figure(heap.name)] = slope;
    else
      results::set_no_value(result, heap_figure(heap.name),
                            "fewer than three columns of the heap's box reach into the middle of its height");
  }
  const std::vector<Zone> zones = zones_in(scene.text);
  add_zone_figures(result, zones);
  for (auto& history : zone_histories(result, zones)) result.probes.push_back(std::move(history));
  return result;
}

}  // namespace diefill::process
