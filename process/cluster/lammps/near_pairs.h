// Near pairs of spheres on a rank, with the contact history of touching ones.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/contact/contact_kernel.h"
#include "process/cluster/lammps/rank_grains.h"

namespace diefill::process::cluster {

/// Numbers of two spheres among all of a rank, or of a sphere and of a part of a wall.
struct NearPair {
  std::uint32_t own, other;
};
inline std::uint32_t part_of(const NearPair& pair) {
  return pair.other;
}

/// Pairs that may come to touch before the next search.
struct NearPairs {
  std::size_t width = 0;  ///< length of a touching pair's history
  std::vector<NearPair> pair;
  std::vector<std::uint8_t> touching;
  std::vector<double> history;

  void clear() {
    pair.clear();
    touching.clear();
    history.clear();
  }
  void add(const NearPair& added, const double* stored) {
    pair.push_back(added);
    touching.push_back(stored != nullptr);
    for (std::size_t k = 0; k < width; ++k) history.push_back(stored ? stored[k] : 0.0);
  }
  double* history_of(std::size_t p) { return history.data() + p * width; }
  const double* history_of(std::size_t p) const { return history.data() + p * width; }
  /// Records whether p touches now; a new contact starts without history.
  void note(std::size_t p, bool touches) {
    if (touches && !touching[p]) std::fill_n(history_of(p), width, 0.0);
    touching[p] = touches;
  }
};

/// Adds the figures of a batch, each lane with its weight.
template <class Law>
void book(const engine::ContactBatch<Law>& batch, const double* weight, ContactFigures& figures) {
  for (std::size_t lane = 0; lane < batch.count; ++lane) {
    figures.viscous_power += weight[lane] * batch.viscous_power[lane];
    figures.friction_power += weight[lane] * batch.friction_power[lane];
    if constexpr (Law::kRolls) figures.rolling_power += weight[lane] * batch.rolling_power[lane];
    figures.touching += batch.overlap[lane] > 0 ? weight[lane] : 0;
  }
}

}  // namespace diefill::process::cluster
