// Walls of a periodic scene: a tool that reaches from border to border gets rows of wall spheres that repeat
// exactly with the period, so a grain that crosses the border meets the same wall on the other side. A tool
// may also stand within the period, such as a blade, and each period has one.
#pragma once

#include "geometry/wall_spheres/wall_spheres.h"
#include "process/scene/scene.h"
#include "process/tooling/stages.h"

namespace diefill::process {

/// The periods of a scene, and how a tool moves along them.
struct PeriodicPath {
  std::array<std::optional<double>, 3> period;        ///< m
  double clearance = 0;                               ///< m, from both borders of tools within a period
  bool may_stand_within = true;                       ///< the period, without reaching across
  Eigen::Vector3d lowest = Eigen::Vector3d::Zero();   ///< m, displacements during the scene, 0 or less
  Eigen::Vector3d highest = Eigen::Vector3d::Zero();  ///< m, 0 or more
  bool turns = false;
};

/// The path of a tool as the steps of the scene, which must have been prepared, move it; displacements under
/// force control and of free tools are not known and left out. Punches and core rods may stand within a
/// period; what holds powder, such as a die, would leave gaps. `clearance`: m.
PeriodicPath periodic_path(const Scene& scene, const ToolSpec& tool, double clearance);

/// Wall spheres of `mesh` (m), made for one period along the periodic axes and repeated as far as `margin`
/// (m) and the tool's way beyond the box. Without periods simply make_wall_spheres(). Throws SceneError
/// (beginning with `where`) as periodic_wall_mesh() does.
geometry::WallSpheres make_periodic_wall_spheres(const geometry::Mesh& mesh,
                                                 const geometry::WallSphereOptions& options,
                                                 const PeriodicPath& path, double margin,
                                                 const std::string& where);

/// The mesh as a wall of its own: in a periodic direction that it reaches across, its ends are stretched to
/// `margin` (m) beyond the box. Without periods the mesh as it is. Throws SceneError (beginning with `where`)
/// for a tool that neither reaches across nor stays within the period by the clearance, whose ends differ, or
/// which moves along a period without being uniform along it.
geometry::Mesh periodic_wall_mesh(const geometry::Mesh& mesh, const PeriodicPath& path, double margin,
                                  const std::string& where);

}  // namespace diefill::process
