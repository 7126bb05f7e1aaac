// Near pairs of one block of grains with what they remember, in the order in which the pair loop streams
// them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/grains.h"

namespace diefill::engine {

/// A near pair between grains: numbers of two spheres (`other` may be an image's), and where their grains'
/// forces are summed in the block.
struct GrainPair {
  std::uint32_t own, other, own_slot, other_slot;
};

/// A near pair with a wall: number of the grain's sphere, of the wall's sphere (or plane) in its body, and
/// where the grain's forces are summed.
struct WallPair {
  std::uint32_t own, wall, own_slot;
};

/// Pairs with a memory of `width` numbers each; what a pair that does not touch remembers has no meaning.
template <class Pair>
struct PairTable {
  std::size_t width = 0;
  std::vector<Pair> pair;
  std::vector<std::uint8_t> touching;  ///< 1 while the pair is within the law's reach
  std::vector<double> memory;          ///< SI units, as the law lays them out

  std::size_t size() const { return pair.size(); }
  void clear() {
    pair.clear();
    touching.clear();
    memory.clear();
  }
  /// `remembered`: `width` numbers of a touching pair, or nullptr.
  void add(const Pair& added, const double* remembered) {
    pair.push_back(added);
    touching.push_back(remembered != nullptr);
    memory.resize(memory.size() + width, 0.0);
    if (remembered)
      std::copy(remembered, remembered + width, memory.end() - static_cast<std::ptrdiff_t>(width));
  }
  double* memory_of(std::size_t p) { return memory.data() + p * width; }
  const double* memory_of(std::size_t p) const { return memory.data() + p * width; }
};

/// A grain outside a block that pairs of the block push, seen where the pairs see it.
struct ForeignGrain {
  std::uint32_t owner;
  Eigen::Vector3d shift;  ///< m, of the image that the pairs meet; 0 for the grain itself
};

/// A run of grains that one thread works on at a time: its pairs, and the forces they cause. Sums 0 to
/// grains() - 1 belong to the block's own grains, the rest to `foreign` ones.
struct Block {
  std::uint32_t begin = 0, end = 0;  ///< grains
  Eigen::Vector3d reference =
      Eigen::Vector3d::Zero();  ///< m, point that moments of composed grains are about
  PairTable<GrainPair> grain_pairs;
  PairTable<WallPair> wall_pairs;         ///< body after body
  std::vector<std::uint32_t> wall_first;  ///< first wall pair of each body, and the number of all
  std::vector<ForeignGrain> foreign;
  std::vector<ContactSum> sums;

  std::uint32_t grains() const { return end - begin; }
};

}  // namespace diefill::engine
