// Grains wedged between tools that move against each other. A real agglomerate at a shearing edge comes
// apart; a rigid model grain can only be pressed deeper until the force laws mean nothing. The owner of the
// simulation decides what becomes of such grains.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// A grain that a moving tool has wedged.
struct PinchedGrain {
  std::uint64_t id;
  Eigen::Vector3d position;  ///< m
  double overlap;            ///< over the radius, its deepest
};

/// Grains to be given up so that nothing is pinched beyond bearing any more, by rising id. Overlaps are taken
/// over the radius of the smaller sphere of grains. Pinched is what lies on a chain of contacts that joins
/// two tools of different velocity; a deep overlap alone, as from a fast impact on one wall, is not pinching.
/// Two kinds of chains are beyond bearing:
/// - of contacts deeper than half the `limit`, one deeper than the limit, past which the force laws mean
///   nothing: the most deeply pressed grain is named;
/// - of contacts deeper than a quarter of the limit, so many that the time step does not carry them
///   (stability_used()): the grain that would swing up is named. Chains of more than some dozens of grains
///   are a bed under load and left alone.
/// Costs nothing worth mentioning while no overlap of the last step is beyond a quarter of the limit, and
/// little then.
std::vector<PinchedGrain> pinched_grains(const Simulation& simulation, double limit);

}  // namespace diefill::engine
