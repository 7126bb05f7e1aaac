// Touching spheres of one block of the pair tables, as of the last step: for figures, messages and other
// occasional questions. The pair loop itself reads the tables in its own way.
#pragma once

#include "engine/contact/mesh_contacts.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// Two spheres of grains that overlapped in the last step.
struct SphereTouch {
  std::size_t sphere, other;  ///< numbers in SphereField, `other` perhaps of an image
  double overlap;             ///< m
  Vector3 normal;             ///< unit vector from the other sphere to `sphere`
};

/// A sphere of a grain that overlapped with a tool.
struct ToolTouch {
  std::size_t sphere;      ///< number in SphereField, of a real grain
  std::size_t body;        ///< number in Simulation::bodies()
  double overlap;          ///< m
  Eigen::Vector3d normal;  ///< unit vector from the tool to the sphere, laboratory frame
};

/// Calls visit(SphereTouch) for every pair of the block's table, in its order.
template <class Visit>
void visit_sphere_touches(const Simulation& simulation, const Block& block, const Visit& visit) {
  const SphereField& spheres = simulation.spheres();
  const auto& table = block.grain_pairs;
  table.visit_touching([&](std::size_t p, const double*) {
    const std::size_t i = block.sphere(table.pair[p].own), j = block.sphere(table.pair[p].other);
    const double reach = simulation.sphere_radius(i) + simulation.sphere_radius(j);
    const Vector3 apart = spheres.position(i) - spheres.position(j);
    const double distance = length(apart);
    if (distance < reach) visit(SphereTouch{i, j, reach - distance, (1 / distance) * apart});
  });
}

/// How a sphere of `radius` (m) at `place` (m, body frame) lies to a wall sphere, plane or triangle: the
/// normal in the body frame.
inline ToolTouch touch_of_part(const WallBody& wall, std::uint32_t part, const Eigen::Vector3d& place,
                               double radius) {
  if (wall.flat()) {
    const WallPlane& plane = wall.planes()[part];
    return {0, 0, radius - plane.normal.dot(place - plane.point), plane.normal};
  }
  const Eigen::Vector3d apart = wall.meshed() ? separation_from_triangle(wall, part, place, radius)
                                              : Eigen::Vector3d(place - wall.centres()[part]);
  const double distance = apart.norm();
  return {0, 0, radius + wall.sphere_radius() - distance, apart / distance};
}

/// Calls visit(ToolTouch) for every pair of the block's table with a tool, in its order.
template <class Visit>
void visit_tool_touches(const Simulation& simulation, const Block& block, const Visit& visit) {
  const SphereField& spheres = simulation.spheres();
  for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
    const WallBody& wall = simulation.bodies()[body];
    const BodyMotion& pose = simulation.body_motion(body);
    for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
      if (!block.wall_pairs.touching[p]) continue;
      const WallPair& pair = block.wall_pairs.pair[p];
      const std::uint32_t i = block.sphere(pair.own);
      const double radius = simulation.sphere_radius(i);
      const Eigen::Vector3d place =
          pose.rotation.transpose() * (eigen(spheres.position(i)) - pose.translation);
      ToolTouch touch = touch_of_part(wall, pair.wall, place, radius);
      if (touch.overlap <= 0) continue;
      touch.sphere = i;
      touch.body = body;
      touch.normal = pose.rotation * touch.normal;
      visit(touch);
    }
  }
}

}  // namespace diefill::engine
