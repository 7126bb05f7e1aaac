// From which size on a run is quicker on ranks: a count of bytes and messages per step, and measured speeds.
#pragma once

#include <cstddef>

namespace diefill::process::cluster {

/// What a forecast assumes about the machine and the programs.
struct RankCosts {
  double built_in_step = 0;  ///< s a sphere and step, one thread of the built-in engine
  /// Speed of a thread of the built-in engine over that of a rank (README.md).
  double slower = 2.5;
  double latency = 2e-6;    ///< s a message; assumed of a cluster's network
  double bandwidth = 1e10;  ///< bytes/s of a rank; assumed
};

/// One step on `ranks` ranks.
struct RankStep {
  double own = 0;       ///< grains of a rank
  double ghosts = 0;    ///< copies of other ranks' grains there
  double messages = 0;  ///< of a rank, sent and received
  double bytes = 0;     ///< received by a rank
  double seconds = 0;   ///< of the whole step
};

/// A compact bed of `grains` grains of `spheres` spheres each, in cubes of equal share.
RankStep rank_step(double grains, std::size_t spheres, int ranks, const RankCosts& costs);

/// The fewest grains for which `ranks` ranks are quicker than `threads` threads of the built-in engine; 0
/// where they never are.
double break_even_grains(std::size_t spheres, int ranks, int threads, const RankCosts& costs);

}  // namespace diefill::process::cluster
