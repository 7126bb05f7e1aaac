// Air that a moving tool draws through the powder, and with it the grains.
#pragma once

#include <Eigen/Geometry>

#include "engine/powder/sphere_field.h"
#include "engine/search/contact_sums.h"

namespace diefill::engine {

/// One-dimensional flow of air that keeps its density: below a rising or falling tool nothing leaks, so that
/// at every height of `region` as much volume of air and grains goes up or down as the tool makes or takes
/// away.
struct AirFlow {
  std::size_t body = 0;            ///< number of the wall body that draws
  Eigen::AlignedBox3d region;      ///< m, laboratory frame: where the powder is in the way of the air
  std::vector<double> resistance;  ///< N s/m a grain of each type: force over the speed of the air against it

  /// Adds the force on each of the grains [begin, end), along z: resistance times the tool's velocity
  /// (`speed`, m/s) less the grain's, predicted for the end of the step as for air at rest (OP-3). `contacts`
  /// has their sums first. Returns the power (W) of these forces.
  double add_forces(const SphereField& grains, std::size_t begin, std::size_t end, double speed,
                    ContactSums& contacts) const;
};

}  // namespace diefill::engine
