#include "process/run/assemble.h"

#include <algorithm>
#include <cstdio>

#include "process/measure/measure.h"

#ifndef DIEFILL_VERSION
#error "the build names the program's version in DIEFILL_VERSION"
#endif

namespace diefill::process {

namespace {

results::PowderState powder_state(const Scene& scene, const engine::Simulation& simulation) {
  const engine::Grains& grains = simulation.grains();
  const engine::GrainShape& shape = simulation.settings().shape;
  results::PowderState powder;
  powder.time = simulation.time();
  powder.grain_diameter = scene.powder.grain_diameter;
  powder.sphere_radius = shape.sphere_radius;
  powder.grain_mass = shape.mass;
  powder.grain_solid_volume = shape.solid_volume;
  powder.sphere_offsets = shape.sphere_offsets;
  powder.id = grains.id;
  powder.position = grains.position;
  powder.orientation = grains.orientation;
  powder.velocity = grains.velocity;
  for (std::size_t k = 0; k < grains.size(); ++k)
    powder.angular_velocity.push_back(simulation.angular_velocity(k));
  return powder;
}

results::ToolState tool_state(const Tool& tool, const engine::BodyMotion& motion) {
  results::ToolState state;
  state.name = tool.spec.name;
  state.role = in_words(tool.spec.role);
  const geometry::Mesh mesh = geometry::transformed(tool.mesh, motion.rotation, motion.translation);
  state.vertices = mesh.vertices;
  state.triangles = mesh.triangles;
  for (const auto& centre : tool.spheres.centres) state.wall_sphere_centres.push_back(motion.point(centre));
  state.wall_sphere_radius = tool.spheres.radius;
  state.mesh_hash = tool.file_hash;
  return state;
}

/// Horizontal direction in which the first moving tool sets out; zero when none moves.
Eigen::Vector3d first_motion(const Scene& scene) {
  constexpr int kInstants = 100;
  for (const auto& step : scene.steps) {
    if (step->tool().empty() || !step->duration()) continue;
    for (int n = 1; n < kInstants; ++n) {
      Eigen::Vector3d velocity = step->motion(*step->duration() * n / kInstants).velocity;
      velocity[2] = 0;
      if (velocity.norm() > 0) return velocity.normalized();
    }
  }
  return Eigen::Vector3d::Zero();
}

results::CavityState cavity_state(const Scene& scene, const Tooling& tooling) {
  const geometry::Cavity& found = tooling.cavity;
  results::CavityState cavity;
  cavity.is_ring = found.is_ring;
  cavity.axis_origin = found.axis_origin;
  cavity.inner_radius = found.inner_radius;
  cavity.outer_radius = found.outer_radius;
  if (found.found) {
    cavity.lower_corner = found.box.lower;
    cavity.upper_corner = found.box.upper;
  }
  cavity.volume = found.volume;
  cavity.narrowest_width = found.narrowest_width;
  const Eigen::Vector3d direction = first_motion(scene);
  if (direction.norm() > 0) cavity.azimuth_zero = -direction;
  return cavity;
}

void add_figures(results::FillResult& result, const Tooling& tooling, const FillRun& run) {
  const engine::Simulation& simulation = run.simulation();
  const auto& settings = simulation.settings();
  const auto grains = static_cast<double>(simulation.grains().size());
  auto& figures = result.figures;
  figures["filled_mass_kg"] = filled_mass(result.powder, result.solid_fraction);
  figures["grains"] = grains;
  figures["spheres"] = grains * static_cast<double>(settings.shape.spheres());
  figures["wall_spheres"] = static_cast<double>(tooling.wall_spheres());
  figures["steps"] = static_cast<double>(simulation.steps());
  figures["time_step_s"] = settings.time_step;
  figures["critical_time_step_s"] = run.critical_time_step();
  figures["time_step_fraction"] = settings.time_step / run.critical_time_step();
  figures["simulated_s"] = simulation.time();
  figures["wall_seconds"] = run.wall_seconds();
  figures["sphere_steps_per_second"] = static_cast<double>(run.sphere_steps()) / run.wall_seconds();
  figures["threads"] = settings.threads;
  figures["energy_balance_error"] = simulation.energy_balance_error();
  figures["deepest_overlap_ratio"] = simulation.overlaps_of_run().grains / settings.shape.sphere_radius;
  figures["deepest_wall_overlap_ratio"] = simulation.overlaps_of_run().walls / settings.shape.sphere_radius;
  figures["grains_left"] = static_cast<double>(run.grains_left());
  figures["mass_left_kg"] = static_cast<double>(run.grains_left()) * settings.shape.mass;
  figures["grain_diameter_m"] = result.powder.grain_diameter;
  figures["bulk_solid_fraction"] = bulk_solid_fraction(result.powder, result.solid_fraction);
  if (result.cavity.volume > 0) {
    figures["cavity_volume_m3"] = result.cavity.volume;
    figures["cavity_narrowest_width_m"] = result.cavity.narrowest_width;
    if (result.cavity.narrowest_width > 0)
      figures["grain_diameter_over_cavity_width"] =
          result.powder.grain_diameter / result.cavity.narrowest_width;
  }
  for (std::size_t phase = 0; phase < engine::kPhaseNames.size(); ++phase)
    result.phase_seconds[engine::kPhaseNames[phase]] = simulation.timers().seconds()[phase];
}

std::vector<results::SectionPlane> wanted_sections(const Scene& scene) {
  std::vector<results::SectionPlane> planes;
  for (const auto& section : scene.measure.sections)
    planes.push_back(section_plane(section.name, section.origin, section.normal));
  return planes;
}

std::string hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

/// The plane that shows most when nobody asked for one: upright, through the middle of the cavity or of the
/// powder, along the shoe's motion.
results::SectionPlane default_section(const results::FillResult& result) {
  Eigen::Vector3d origin = result.cavity.axis_origin;
  if (result.cavity.volume <= 0) {
    origin.setZero();
    for (const auto& position : result.powder.position) origin += position;
    if (!result.powder.position.empty()) origin /= static_cast<double>(result.powder.position.size());
    origin[2] = 0;
  }
  const Eigen::Vector3d along = result.cavity.azimuth_zero;
  return section_plane("along the shoe's motion", origin, Eigen::Vector3d(-along[1], along[0], 0));
}

}  // namespace

std::string program_version() {
  return DIEFILL_VERSION;
}

results::SectionPlane section_plane(const std::string& name, const Eigen::Vector3d& origin,
                                    const Eigen::Vector3d& normal) {
  results::SectionPlane plane;
  plane.name = name;
  plane.origin = origin;
  plane.normal = normal.normalized();
  // Upright planes are seen with z up; a horizontal one with x to the right.
  const bool horizontal = std::abs(plane.normal[2]) > 0.999;
  plane.first_axis = horizontal ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                : Eigen::Vector3d(-Eigen::Vector3d::UnitZ().cross(plane.normal).normalized());
  if (!horizontal && plane.first_axis.sum() < 0) plane.first_axis *= -1;
  plane.second_axis =
      horizontal ? Eigen::Vector3d(Eigen::Vector3d::UnitY())
                 : Eigen::Vector3d((Eigen::Vector3d::UnitZ() - plane.normal[2] * plane.normal).normalized());
  return plane;
}

void measure_fields(results::FillResult& result, const FieldRequest& request, int azimuth_bins) {
  constexpr double kDefaultWidth = 5e-4;  // m, Bierwisch 2009, Figs. 3.6, 4.12
  const double width = request.averaging_width > 0
                           ? request.averaging_width
                           : std::max(kDefaultWidth, 0.5 * result.powder.grain_diameter);
  result.maps.clear();
  result.sections.clear();
  result.profiles.clear();
  if (result.cavity.is_ring) {
    result.maps.push_back(cylindrical_map(result.powder, result.solid_fraction, result.cavity, width));
    result.profiles.push_back(fill_level(result.powder, result.cavity, azimuth_bins));
  }
  auto planes = request.sections;
  if (planes.empty()) planes.push_back(default_section(result));
  for (const auto& plane : planes)
    result.sections.push_back(
        plane_section(result.powder, result.solid_fraction, result.tools, plane, width));
}

results::FillResult assemble(const Scene& scene, const Tooling& tooling, const FillRun& run) {
  results::FillResult result;
  result.title = scene.title;
  result.strategy = strategy_in_words(scene);
  result.powder_name = scene.powder.name;
  result.scene_text = scene.text;
  result.program_version = program_version();
  result.seed = scene.seed;
  result.state_hash = hexadecimal(run.simulation().hash());
  result.powder = powder_state(scene, run.simulation());
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    result.tools.push_back(tool_state(tooling.tools[k], run.simulation().body_motion(k)));
  result.cavity = cavity_state(scene, tooling);
  result.solid_fraction =
      measure_solid_fraction(result.powder, result.tools, result.cavity, scene.numerics.period);
  result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
  add_figures(result, tooling, run);
  result.warnings = tooling.remarks();
  for (const auto& warning : run.warnings()) result.warnings.push_back(warning);
  measure_fields(result, {scene.measure.averaging_width, wanted_sections(scene)}, scene.measure.azimuth_bins);
  return result;
}

}  // namespace diefill::process
