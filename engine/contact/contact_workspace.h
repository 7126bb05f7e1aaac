// What one worker needs while it computes the contact forces of a block.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/mesh_contacts.h"
#include "engine/contact/touching_pair.h"
#include "engine/powder/grains.h"

namespace diefill::engine {

/// Memory of one worker, used again block after block; only `sums` have a meaning between two calls.
struct ContactWorkspace {
  /// Of the block's pairs, one for each of Block::sums; all 0 between blocks.
  std::vector<ContactSum> sums;
  std::vector<TouchingPair> touching;    ///< pairs of grains
  std::vector<double> next_history;      ///< of pairs of grains after the step
  std::vector<WallTouch> wall_touching;  ///< pairs with one body
  MeshWorkspace mesh;
};

}  // namespace diefill::engine
