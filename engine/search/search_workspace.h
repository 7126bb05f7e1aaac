// What one worker needs while it finds the near pairs of a block.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/search/sphere_cells.h"

namespace diefill::engine {

/// A part of a body (wall sphere, plane or triangle) that is near a sphere, and how far away, m, rounded
/// down; 0 where that is not known.
struct NearPart {
  float distance;
  std::uint32_t part;

  bool operator<(const NearPart& other) const {
    return distance != other.distance ? distance < other.distance : part < other.part;
  }
};

/// Memory of one worker, used again block after block; nothing in it outlives a block.
struct SearchWorkspace {
  std::vector<SphereCells::Candidate> candidates;
  std::vector<std::uint32_t> found;  ///< parts of one body near one sphere, unsorted
  std::vector<NearPart> near_parts;  ///< the same with distances
  std::vector<std::uint32_t> parts;  ///< near all spheres of the block, body after body
};

}  // namespace diefill::engine
