#include "geometry/wall_spheres/cover_samples.h"

namespace diefill::geometry {

PointGrid reachable_points(const CoverTarget& target, double step) {
  PointGrid points(2 * step);
  const auto reachable_in = [&](const Stretch& stretch) {
    std::vector<Eigen::Vector3d> reachable;
    visit_facets(target.facets, stretch, [&](std::size_t f, std::size_t begin, std::size_t end, bool) {
      for (std::size_t place = begin; place < end; ++place)
        sample_triangle(corners_of(target.mesh, target.facets[f].triangles[place]), step,
                        [&](const SurfaceSample& sample) {
                          if (target.reachable(sample.point, sample.normal))
                            reachable.push_back(sample.point);
                        });
    });
    return reachable;
  };
  StretchProgress progress(target, 0, kHolesBegin);
  work_while_taking(target.stretches, reachable_in, [&](const std::vector<Eigen::Vector3d>& reachable) {
    progress.next();
    for (const Eigen::Vector3d& point : reachable)
      if (!points.any_within(point, step / 2)) points.insert(point);
  });
  return points;
}

PointGrid powder_parts(const PointGrid& reachable, double radius) {
  PointGrid kept(kPartLength * radius);
  for (const Eigen::Vector3d& point : reachable.points())
    if (!kept.any_within(point, kThinning * radius)) kept.insert(point);
  return kept;
}

}  // namespace diefill::geometry
