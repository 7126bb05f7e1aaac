#include "process/cluster/rank_forecast.h"

#include <algorithm>
#include <cmath>

#include "process/run/check_intervals.h"

namespace diefill::process::cluster {

namespace {

/// Of a ghost in a step: centre, velocity and spin, and of clumps the orientation.
constexpr double kBytesOfSphere = 9 * 8, kBytesOfClump = 13 * 8;
/// Width of the layer of ghosts over the distance of grains in a bed: the reach of two grains and the skin.
constexpr double kLayer = 1.2;
/// Neighbours of a rank in space, and messages with each: both state and, of clumps, orientations.
constexpr double kNeighbours = 26;
/// Bytes a grain to rank 0, and the steps between two such messages.
constexpr double kShown = 20 * 8, kShownEvery = kSpillInterval;
constexpr double kMaxGrains = 1e9;

}  // namespace

RankStep rank_step(double grains, std::size_t spheres, int ranks, const RankCosts& costs) {
  RankStep step;
  step.own = grains / ranks;
  const double edge = std::cbrt(step.own);
  const bool alone = ranks == 1, clumps = spheres > 1;
  step.ghosts = alone ? 0 : std::min(grains - step.own, std::pow(edge + 2 * kLayer, 3) - step.own);
  const double neighbours = std::min(kNeighbours, static_cast<double>(ranks - 1));
  const double levels = std::ceil(std::log2(static_cast<double>(ranks)));
  step.messages = alone ? 0 : 2 * neighbours * (clumps ? 2 : 1) + 2 * levels;
  step.bytes = step.ghosts * (clumps ? kBytesOfClump : kBytesOfSphere);
  const double sphere = costs.slower * costs.built_in_step;
  // A pair with a ghost is computed on both sides: half of the ghosts' work is done twice.
  const double computing = static_cast<double>(spheres) * sphere * (step.own + 0.5 * step.ghosts);
  const double shown = alone ? 0 : grains * kShown / kShownEvery / costs.bandwidth;
  step.seconds = computing + step.messages * costs.latency + step.bytes / costs.bandwidth + shown;
  return step;
}

double break_even_grains(std::size_t spheres, int ranks, int threads, const RankCosts& costs) {
  const auto pays = [&](double grains) {
    const double built_in = grains * static_cast<double>(spheres) * costs.built_in_step / threads;
    return rank_step(grains, spheres, ranks, costs).seconds < built_in;
  };
  for (double grains = ranks; grains < kMaxGrains; grains *= 1.1)
    if (pays(grains)) return grains;
  return 0;
}

}  // namespace diefill::process::cluster
