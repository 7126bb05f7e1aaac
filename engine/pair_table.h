// Near pairs of one block of grains with what they remember, in the order in which the pair loop streams
// them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/grains.h"

namespace diefill::engine {

/// Partner of a near pair between grains. `sphere` and `grain` may be images; `slot` is where the partner's
/// forces are summed in the block.
struct GrainPartner {
  std::uint32_t sphere, grain, slot;
};

/// Partner of a near pair with a wall: sphere number in its body.
struct WallPartner {
  std::uint32_t sphere, body;
};

/// Pairs of the spheres of one block: those of the block's sphere s are [first[s], first[s + 1]).
template <class Partner>
struct PairTable {
  std::vector<std::uint32_t> first;
  std::vector<Partner> partner;
  std::vector<std::uint8_t> touching;  ///< 1 while the pair overlaps
  std::vector<Eigen::Vector3d>
      spring;  ///< m, tangential spring of the sphere against its partner; 0 unless touching

  void clear() {
    first.assign(1, 0);
    partner.clear();
    touching.clear();
    spring.clear();
  }
  void add(const Partner& added, bool touches, const Eigen::Vector3d& remembered) {
    partner.push_back(added);
    touching.push_back(touches);
    spring.push_back(remembered);
  }
};

/// A run of grains that one thread works on at a time: its pairs, and the forces they cause. Sums 0 to
/// grains() - 1 belong to the block's own grains, the rest to `foreign` ones.
struct Block {
  std::uint32_t begin = 0, end = 0;  ///< grains
  PairTable<GrainPartner> grain_pairs;
  PairTable<WallPartner> wall_pairs;
  std::vector<std::uint32_t> foreign;  ///< grains of other blocks that pairs of this one push
  std::vector<ContactSum> sums;

  std::uint32_t grains() const { return end - begin; }
};

}  // namespace diefill::engine
