// Half models: where tools and their motions are mirror images of themselves, half the powder is computed in
// front of a plane that acts on grains as their images behind it would, and results show both halves. What is
// lost: powder is never quite symmetric, so the scatter between the halves is missing, and no grain can lie
// across the plane.
#pragma once

#include <vector>

#include "engine/walls/wall_load.h"
#include "engine/walls/walls.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/results/fill_result.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Throws SceneError when tools or motions are not mirror images of themselves. Steps must have been
/// prepared. Like all functions below it does nothing without a mirror plane.
void refuse_asymmetry(const Scene& scene, const Tooling& tooling);

/// Drops the wall spheres that powder in front of the mirror plane cannot touch.
void keep_near_half(const Scene& scene, geometry::WallSpheres& spheres);

/// The mirror plane as a wall at which grains meet their images.
engine::WallBodySpec mirror_wall(int axis);

/// m: where centres of grains of bounding `radius` (m) may start in an inflow's box: those that touch the
/// mirror plane would overlap with their images. Flat where half of the box is narrower than the radius.
geometry::Box start_box(const Tooling& tooling, const PowderInflow& inflow, double radius);

/// 2 for a half model, 1 otherwise: the factor of a grain, a mass, an energy.
double copies(const Tooling& tooling);

/// The load of both halves on a tool.
engine::WallLoad whole_load(const Tooling& tooling, const engine::WallLoad& load);

/// Calls visit(place) for the place and its image.
template <class Visit>
void visit_images(const Tooling& tooling, const Eigen::Vector3d& place, const Visit& visit) {
  visit(place);
  if (!tooling.mirror) return;
  Eigen::Vector3d image = place;
  image[*tooling.mirror] = -image[*tooling.mirror];
  visit(image);
}

/// Both halves of the powder, of its stress, of an instant kept on the way, of centres of wall spheres.
/// Images follow the grains; their ids are those of the grains and 2^32.
void add_images(const Tooling& tooling, results::PowderState& powder);
void add_images(const Tooling& tooling, results::ContactStress& stress);
/// `powder`: as it is at the end, for the shape of its grains.
void add_images(const Tooling& tooling, const results::PowderState& powder, results::Instant& instant);
void add_images(const Tooling& tooling, std::vector<Eigen::Vector3d>& centres);

}  // namespace diefill::process
