#include "process/setup/build_tooling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <utility>

#include "geometry/reach/moving_pair.h"
#include "process/results/formatted.h"
#include "process/setup/cover_tooling.h"
#include "process/setup/predicted_work.h"
#include "process/setup/reachable_surface.h"
#include "process/setup/read_tooling.h"
#include "process/setup/wall_sphere_limit.h"
#include "process/tooling/cover_progress.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/half_model.h"
#include "process/tooling/periodic_tool.h"

namespace diefill::process {

namespace {

// Shares of the work after reading, as a die of ten million triangles has them.
constexpr double kToolsFit = 0.3, kReachKnown = 0.33;

/// Openings measured between centres (OP-12): the spheres' centres, not their surfaces, lie on the CAD
/// surface.
void move_to_surface(geometry::WallSpheres& spheres, const geometry::SolidQuery& solid) {
  for (auto& centre : spheres.centres) centre = solid.nearest(centre).point;
  spheres.mean_deviation += spheres.radius;
  spheres.largest_deviation += spheres.radius;
}

bool is_mesh(const Scene& scene, const ToolSpec& spec) {
  return spec.walls.value_or(scene.walls.kind) == WallKind::mesh;
}

/// Covers the tool. Where the mesh is the wall, spheres only cut the cells of grains that measures take: in
/// sheet thinner than they are they are made as small as it needs.
geometry::WallSpheres spheres_of(const Scene& scene, const Tool& tool, double grain_diameter,
                                 geometry::WallSphereOptions options, const std::string& where) {
  constexpr double kShareOfSheet = 0.45;
  constexpr int kHalvings = 3;
  const auto& period = scene.numerics.period;
  const auto make = [&] {
    return period[0] || period[1] || period[2]
               ? make_periodic_wall_spheres(tool.mesh, options,
                                            periodic_path(scene, tool.spec, grain_diameter),
                                            2 * grain_diameter, where)
               : geometry::make_wall_spheres(tool.mesh, tool.solid(), options);
  };
  if (!is_mesh(scene, tool.spec)) return make();
  options.radius = std::min(options.radius, kShareOfSheet * geometry::mean_thickness(tool.mesh));
  for (int halving = 0; halving < kHalvings; ++halving, options.radius *= 0.5) try {
      return make();
    } catch (const geometry::MeshError&) {
      continue;
    }
  return make();
}

/// What a user may do about a solid `thickness` (m) thick, thinner than a wall sphere, but to thicken it.
std::string other_ways_for_sheet(const Scene& scene, const ToolSpec& spec, double thickness) {
  constexpr double kSmallestRadius = 1e-6;  // m, that a scene may ask for (wall_rules.h)
  std::string ways;
  if (0.5 * thickness > kSmallestRadius)
    ways += results::formatted(", or reduce sphere_radius below %.4g mm", 0.5e3 * thickness);
  if (!is_mesh(scene, spec)) ways += ", or set walls = \"mesh\" for this tool";
  return ways;
}

/// The tool's wall spheres; errors in its geometry name the tool.
geometry::WallSpheres cover(const Scene& scene, const Tool& tool, double grain_diameter,
                            decltype(geometry::WallSphereOptions::reachable) reachable,
                            decltype(geometry::WallSphereOptions::on_progress) on_progress) {
  const std::string where = tool_text(scene, tool.spec);
  geometry::WallSphereOptions options;
  options.radius = wall_sphere_radius(scene, tool.spec);
  options.spacing = tool.spec.spacing.value_or(scene.walls.spacing);
  options.reachable = std::move(reachable);
  options.on_progress = std::move(on_progress);
  try {
    auto spheres = spheres_of(scene, tool, grain_diameter, options, where);
    if (scene.numerics.opening == OpeningMeasure::centres) move_to_surface(spheres, tool.solid());
    keep_near_half(scene, spheres);
    return spheres;
  } catch (const geometry::ThinSolid& thin) {
    throw SceneError(where + ": " + thin.what() + other_ways_for_sheet(scene, tool.spec, thin.thickness));
  } catch (const geometry::MeshError& error) {
    throw SceneError(where + ": " + error.what());
  }
}

/// The surface that powder meets where the mesh itself is the wall.
geometry::Mesh wall_mesh(const Scene& scene, const Tool& tool, double grain_diameter) {
  return periodic_wall_mesh(tool.mesh, periodic_path(scene, tool.spec, grain_diameter), 4 * grain_diameter,
                            tool_text(scene, tool.spec));
}

void refuse_leaks(const Scene& scene, const Tool& tool, double smallest_radius) {
  if (tool.spheres.largest_gap < 2 * smallest_radius) return;
  char text[300];
  const Eigen::Vector3d place = tool.spheres.largest_gap_place * 1e3;
  std::snprintf(text, sizeof text,
                ": a sphere of a grain, %.4g mm in diameter, could pass the wall through a gap of %.4g mm "
                "near (%.2f, %.2f, %.2f) mm; reduce the spacing or the radius of the wall spheres",
                2e3 * smallest_radius, 1e3 * tool.spheres.largest_gap, place[0], place[1], place[2]);
  throw SceneError(tool_text(scene, tool.spec) + text);
}

}  // namespace

Tooling build_tooling(const Scene& scene, double smallest_radius, double grain_diameter,
                      const ProgressCallback& on_progress) {
  refuse_excessive_work(scene);
  return cover_tooling(scene, read_tooling(scene, on_progress), smallest_radius, grain_diameter, on_progress);
}

Tooling cover_tooling(const Scene& as_read, Tooling tooling, double smallest_radius, double grain_diameter,
                      const ProgressCallback& on_progress) {
  const Scene scene = with_prepared_steps(as_read, tooling);
  on_progress(kToolsFit, "finding surfaces that powder can reach");
  const ReachableSurface reachable(scene, tooling, grain_diameter);
  const auto needs_wall = [&](std::size_t tool, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    return !scene.economy.skip_far_walls || reachable(tool, point, normal);
  };
  refuse_too_many_wall_spheres(scene, tooling, needs_wall);
  std::vector<CoverProgress::Part> parts;
  for (const Tool& tool : tooling.tools)
    parts.push_back({tool.spec.name, static_cast<double>(tool.mesh.triangles.size())});
  CoverProgress progress(parts);
  // Tools are independent of each other: they are covered in parallel.
  std::vector<std::future<geometry::WallSpheres>> covered;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    covered.push_back(std::async(std::launch::async, [&, k] {
      return cover(
          scene, tooling.tools[k], grain_diameter,
          [&, k](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
            return needs_wall(k, point, normal);
          },
          [&, k](double share) { progress.done(k, share); });
    }));
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    Tool& tool = tooling.tools[k];
    tool.spheres = progress.wait_for(k, covered[k], kReachKnown, on_progress);
    if (is_mesh(scene, tool.spec))
      tool.wall_mesh = wall_mesh(scene, tool, grain_diameter);
    else
      refuse_leaks(scene, tool, smallest_radius);
  }
  return tooling;
}

}  // namespace diefill::process
