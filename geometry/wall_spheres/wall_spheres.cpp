#include "geometry/wall_spheres/wall_spheres.h"

#include <cmath>
#include <string>

#include "geometry/grids/all_cores.h"
#include "geometry/wall_spheres/wall_cover.h"
#include "geometry/wall_spheres/wall_layout.h"
#include "geometry/wall_spheres/wall_rows.h"

namespace diefill::geometry {

namespace {

void check(const WallSphereOptions& options) {
  if (!(std::isfinite(options.radius) && options.radius > 0))
    throw MeshError("the radius of wall spheres must be positive, not " + std::to_string(options.radius) +
                    " m");
  if (!(std::isfinite(options.spacing) && options.spacing >= 0.2 && options.spacing <= 10))
    throw MeshError("the spacing of wall spheres must be between 0.2 and 10 radii, not " +
                    std::to_string(options.spacing) + "; 1.6 is usual");
}

}  // namespace

WallSpheres make_wall_spheres(const Mesh& mesh, const WallSphereOptions& options) {
  check(options);
  return make_wall_spheres(mesh, SolidQuery(mesh), options);
}

WallSpheres make_wall_spheres(const Mesh& mesh, const SolidQuery& solid, const WallSphereOptions& options) {
  check(options);
  const double spacing = options.spacing * options.radius;
  const Facets facets = find_facets(mesh, solid.topology());
  CoverTarget target{mesh,
                     facets,
                     options.reachable,
                     stretches_of(facets),
                     PointGrid(spacing),
                     PointGrid(spacing),
                     options.on_progress};
  const OffsetSurface offset(solid, options.radius);

  std::function<bool(const Eigen::Vector3d&)> wanted = [](const Eigen::Vector3d&) { return true; };
  Strips strips;
  const auto lay_strips = [&] { strips = find_strips(facets, options.radius, spacing); };
  if (options.reachable) {
    // Spheres up to about a spacing beyond the reachable surface close its edge.
    side_by_side(lay_strips, [&] {
      target.near_powder = reachable_points(target, options.radius);
      target.powder_parts = powder_parts(target.near_powder, options.radius);
    });
    wanted = [&](const Eigen::Vector3d& foot) { return target.near_powder.any_within(foot, 1.4 * spacing); };
  } else {
    lay_strips();
  }
  WallLayout layout(offset, spacing, wanted);
  for (const Strip& strip : strips.bent) layout.add_grid(strip);
  add_edge_rows(facets, layout);
  for (const Strip& strip : strips.plane) layout.add_grid(strip);
  SamplesKnown known = close_cover(target, layout);

  WallSpheres spheres;
  spheres.radius = options.radius;
  spheres.centres = layout.centres().points();
  measure_cover(target, layout, known, spheres);
  return spheres;
}

}  // namespace diefill::geometry
