// Grains counted by particle type, and their mass: exact for any number of grains in any order.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/powder/particle_types.h"

namespace diefill::process {

class GrainTally {
 public:
  GrainTally() = default;
  explicit GrainTally(std::vector<std::uint64_t> by_kind) : by_kind_(std::move(by_kind)) {}

  void add(engine::TypeNumber kind, std::uint64_t grains = 1) {
    if (by_kind_.size() <= kind) by_kind_.resize(kind + std::size_t{1});
    by_kind_[kind] += grains;
  }
  std::uint64_t grains() const {
    std::uint64_t sum = 0;
    for (const auto count : by_kind_) sum += count;
    return sum;
  }
  /// kg.
  double mass(const engine::ParticleTypes& kinds) const {
    double sum = 0;
    for (std::size_t k = 0; k < by_kind_.size(); ++k)
      sum += static_cast<double>(by_kind_[k]) * kinds.shape(static_cast<engine::TypeNumber>(k)).mass;
    return sum;
  }
  const std::vector<std::uint64_t>& by_kind() const { return by_kind_; }

 private:
  std::vector<std::uint64_t> by_kind_;
};

}  // namespace diefill::process
