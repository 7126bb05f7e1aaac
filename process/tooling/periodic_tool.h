// Walls of a periodic scene: a tool that is uniform along the periodic direction gets rows of wall spheres
// that repeat exactly with the period, so a grain that crosses the border meets the same wall on the other
// side.
#pragma once

#include "geometry/wall_spheres/wall_spheres.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Wall spheres of `mesh` (m), made for one period along the periodic axes and repeated as far as `margin`
/// (m) beyond the box. Without periods simply make_wall_spheres(). Throws SceneError (beginning with `where`)
/// when the tool is not prismatic along a periodic axis or shorter than the period.
geometry::WallSpheres make_periodic_wall_spheres(const geometry::Mesh& mesh,
                                                 const geometry::WallSphereOptions& options,
                                                 const std::array<std::optional<double>, 3>& period,
                                                 double margin, const std::string& where);

/// The mesh as a wall of its own: in a periodic direction a prism is stretched to `margin` (m) beyond the
/// box. Without periods the mesh as it is. Throws SceneError (beginning with `where`) for tools that are no
/// prisms.
geometry::Mesh periodic_wall_mesh(const geometry::Mesh& mesh,
                                  const std::array<std::optional<double>, 3>& period, double margin,
                                  const std::string& where);

}  // namespace diefill::process
