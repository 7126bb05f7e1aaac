#include "process/run/lost_grains.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "engine/numerics/out_of_range.h"
#include "geometry/reach/solid_rows.h"

namespace diefill::process {

namespace {

constexpr double kMaxVoxels = 5e7;  // of a tool, one byte each

engine::OutOfRange through_the_wall(const engine::Simulation& simulation, std::size_t k, double depth,
                                    const Tool& tool) {
  const Eigen::Vector3d place = 1e3 * simulation.grains().position[k];
  char text[400];
  std::snprintf(text, sizeof text,
                "grain %llu is %.3g mm inside tool \"%s\" at (%.2f, %.2f, %.2f) mm, t = %.6g s: it passed "
                "through the wall; %s",
                static_cast<unsigned long long>(simulation.grains().id[k]), 1e3 * depth,
                tool.spec.name.c_str(), place[0], place[1], place[2], simulation.time(),
                tool.wall_mesh ? "reduce the speed of the tool, or make the contacts stiffer"
                               : "reduce the spacing of the wall spheres or the speed of the tool");
  return engine::OutOfRange(text);
}

}  // namespace

LostGrains::LostGrains(const Tooling& tooling, std::vector<double> grain_diameters)
    : tooling_(tooling), grain_diameters_(std::move(grain_diameters)) {
  const double grain_diameter = grain_diameters_.front();
  for (const Tool& tool : tooling.tools) {
    const geometry::Box box = tool.mesh.bounding_box();
    // Fine grains in a large tool: rather ask the solid about every grain than fill the memory with voxels.
    const bool in_voxels = (2 * box.size() / grain_diameter).cwiseMax(1).prod() <= kMaxVoxels;
    const auto grid =
        geometry::VoxelGrid::over(box, in_voxels ? 0.5 * grain_diameter : box.size().maxCoeff());
    const std::array<const geometry::Mesh*, 1> meshes = {&tool.mesh};
    std::vector<std::uint8_t> blocked;
    if (in_voxels) blocked = geometry::blocked_voxels(grid, meshes, 0);
    geometry::PointGrid spheres(2 * grain_diameter);
    for (const auto& centre : tool.spheres.centres) spheres.insert(centre);
    // A covered point is no farther from a centre than this: half a gap between spheres, and their depth.
    const double cover_reach = 2 * tool.spheres.radius + tool.spheres.largest_gap;
    tools_.push_back({tool.solid(), grid, std::move(blocked), std::move(spheres), cover_reach});
  }
}

/// Where on the surface (m, body frame) a grain at `place`, moving with `velocity` (m/s) against the tool,
/// came in. At the last check, `interval` (s) ago, it was at most half a grain deep: back along its way to
/// such a depth, at most twice as far as it went since then, for it may have been faster, and from there to
/// the nearest surface. Farther back the velocity tells nothing: a grain half in a tool may have bounced off
/// wall spheres that stand beside the place where it came in.
Eigen::Vector3d LostGrains::entry(const Inside& tool, const Eigen::Vector3d& place,
                                  const Eigen::Vector3d& velocity, double grain_diameter,
                                  double interval) const {
  const double step = 0.25 * grain_diameter, farthest = 2 * velocity.norm() * interval;
  for (double way = step; way <= farthest; way += step) {
    const auto before = tool.solid.signed_nearest(place - way * velocity.normalized());
    if (!before.inside || before.distance <= 0.5 * grain_diameter) return before.point;
  }
  return tool.solid.nearest(place).point;
}

std::vector<StrayGrain> LostGrains::strayed(const engine::Simulation& simulation, double interval) const {
  std::vector<StrayGrain> strayed;
  const auto& grains = simulation.grains();
  for (std::size_t b = 0; b < tools_.size(); ++b) {
    const engine::BodyMotion& pose = simulation.body_motion(b);
    const Inside& tool = tools_[b];
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const Eigen::Vector3d place = pose.rotation.transpose() * (grains.position[k] - pose.translation);
      const Eigen::Vector3i voxel = tool.grid.voxel_at(place);
      if (!tool.grid.has(voxel)) continue;
      if (!tool.blocked.empty() && !tool.blocked[tool.grid.index(voxel.x(), voxel.y(), voxel.z())]) continue;
      const double depth = -tool.solid.signed_distance(place);
      const double diameter = grain_diameters_[grains.type_of(k)];
      if (depth <= 0.5 * diameter) continue;
      const Eigen::Vector3d velocity =
          pose.rotation.transpose() * (grains.velocity[k] - pose.velocity_at(grains.position[k]));
      if (tool.wall_spheres.any_within(entry(tool, place, velocity, diameter, interval), tool.cover_reach))
        throw through_the_wall(simulation, k, depth, tooling_.tools[b]);
      strayed.push_back({grains.id[k], b, grains.position[k]});
    }
  }
  // Where tools touch, a grain may have come into two.
  std::ranges::stable_sort(strayed, {}, &StrayGrain::id);
  const auto repeated = std::ranges::unique(strayed, {}, &StrayGrain::id);
  strayed.erase(repeated.begin(), repeated.end());
  return strayed;
}

}  // namespace diefill::process
