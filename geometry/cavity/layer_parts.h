// The connected parts of a cavity in every layer of its voxels, and which lies on which: pockets that join
// further up are separate parts below.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/cavity/cavity_region.h"

namespace diefill::geometry {

/// Voxels of one layer that hang together through their sides.
struct LayerPart {
  int layer = 0;                     ///< of the region's grid
  std::size_t voxels = 0;            ///< in the part itself
  std::size_t down = 0;              ///< in it and all parts below it that lead up into it
  std::vector<std::size_t> below;    ///< parts of the layer below that touch it
  std::optional<std::size_t> above;  ///< the part of the layer above that touches it, the first of several
};

/// All parts of a region, the lowest layer first.
struct LayerParts {
  std::vector<LayerPart> parts;
  std::vector<std::int32_t> part_at;  ///< by voxel: which of `parts`; -1 outside the cavity
};

LayerParts layer_parts(const CavityRegion& region);

}  // namespace diefill::geometry
