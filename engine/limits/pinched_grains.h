// Grains wedged between tools that move against each other. A real agglomerate at a shearing edge comes
// apart; a rigid model grain can only be pressed deeper until the force laws are no longer valid. The
// owner of the simulation decides what to do with such grains.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace diefill::engine {

class Simulation;

/// A grain that a moving tool has wedged.
struct PinchedGrain {
  std::uint64_t id;
  Eigen::Vector3d position;  ///< m
  double overlap;            ///< over the radius, its deepest
};

/// Grains to remove so that none is pinched beyond the limits any more, by rising id. Overlaps are relative
/// to the radius of the smaller sphere of grains. A grain is pinched if it lies on a chain of contacts that
/// joins two tools of different velocity, of which a plane of symmetry is none; a deep overlap alone, as from
/// a fast impact on one wall, is not pinching. Two kinds of chains are beyond the limits:
/// - chains of contacts deeper than half the `limit`, one of them deeper than the limit, beyond which the
///   force laws are not valid: returns the most deeply pressed grain;
/// - chains of contacts deeper than a quarter of the limit, so many that the time step is unstable for them
///   (stability_used()): returns the grain of largest amplitude. Chains of more than some dozens of grains
///   are a bed under load and are skipped.
/// The cost is negligible while no overlap of the last step is beyond a quarter of the limit, and small then.
std::vector<PinchedGrain> pinched_grains(const Simulation& simulation, double limit);

}  // namespace diefill::engine
