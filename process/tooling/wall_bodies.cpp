#include "process/tooling/wall_bodies.h"

#include <cmath>

#include "process/powder/tool_surface.h"
#include "process/tooling/half_model.h"

namespace diefill::process {
namespace {

/// The mesh as the engine takes it; triangles without area face nowhere and are left out.
std::vector<engine::WallTriangle> wall_triangles(const geometry::Mesh& mesh) {
  std::vector<engine::WallTriangle> triangles;
  for (const Eigen::Vector3i& corners : mesh.triangles) {
    engine::WallTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
      triangle.corner[k] = mesh.vertices[static_cast<std::size_t>(corners[static_cast<Eigen::Index>(k)])];
    if (std::abs(triangle.normal().norm() - 1) < 1e-9) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

std::vector<engine::WallBodySpec> wall_bodies(const Scene& scene, const Tooling& tooling) {
  std::vector<engine::WallBodySpec> bodies;
  for (const Tool& tool : tooling.tools) {
    engine::WallBodySpec body;
    body.name = tool.spec.name;
    body.material = material_of(tool.spec);
    body.sphere_radius = tool.spheres.radius;
    if (tool.wall_mesh)
      body.triangles = wall_triangles(*tool.wall_mesh);
    else
      body.centres = tool.spheres.centres;
    if (scene.walls.contact_radius == MeshContactRadius::wall_spheres)
      body.contact_radius = tool.spec.sphere_radius.value_or(scene.walls.sphere_radius);
    bodies.push_back(std::move(body));
  }
  if (tooling.mirror) bodies.push_back(mirror_wall(*tooling.mirror));
  return bodies;
}

}  // namespace diefill::process
