#include "geometry/cavity/layer_parts.h"

#include <algorithm>

namespace diefill::geometry {
namespace {

constexpr std::int32_t kOutside = -1, kUnseen = -2;

// Gives all voxels of a layer that are connected to `seed` the number `part`; how many they are.
std::size_t spread(const VoxelGrid& grid, const Eigen::Vector3i& seed, std::int32_t part,
                   std::vector<std::int32_t>& part_at) {
  std::size_t count = 0;
  std::vector<Eigen::Vector3i> front;
  const auto take = [&](const Eigen::Vector3i& voxel) {
    if (!grid.has(voxel)) return;
    std::int32_t& here = part_at[grid.index(voxel.x(), voxel.y(), voxel.z())];
    if (here != kUnseen) return;
    here = part;
    ++count;
    front.push_back(voxel);
  };
  take(seed);
  while (!front.empty()) {
    const Eigen::Vector3i voxel = front.back();
    front.pop_back();
    for (const int axis : {0, 1}) {
      for (const int step : {-1, 1}) {
        Eigen::Vector3i beside = voxel;
        beside[axis] += step;
        take(beside);
      }
    }
  }
  return count;
}

void add_parts_of_layer(const VoxelGrid& grid, int layer, LayerParts& found) {
  for (int j = 0; j < grid.counts.y(); ++j) {
    for (int i = 0; i < grid.counts.x(); ++i) {
      if (found.part_at[grid.index(i, j, layer)] != kUnseen) continue;
      LayerPart part;
      part.layer = layer;
      part.voxels = spread(grid, {i, j, layer}, static_cast<std::int32_t>(found.parts.size()), found.part_at);
      found.parts.push_back(part);
    }
  }
}

// Notes which parts of `layer` lie on which of the layer below.
void join_with_layer_below(const VoxelGrid& grid, int layer, LayerParts& found) {
  for (int j = 0; j < grid.counts.y(); ++j) {
    for (int i = 0; i < grid.counts.x(); ++i) {
      const std::int32_t here = found.part_at[grid.index(i, j, layer)];
      const std::int32_t under = found.part_at[grid.index(i, j, layer - 1)];
      if (here < 0 || under < 0) continue;
      auto& below = found.parts[static_cast<std::size_t>(here)].below;
      const auto lower = static_cast<std::size_t>(under);
      if (std::find(below.begin(), below.end(), lower) != below.end()) continue;
      below.push_back(lower);
      if (!found.parts[lower].above) found.parts[lower].above = static_cast<std::size_t>(here);
    }
  }
}

}  // namespace

LayerParts layer_parts(const CavityRegion& region) {
  LayerParts found;
  found.part_at.resize(region.inside.size());
  std::transform(region.inside.begin(), region.inside.end(), found.part_at.begin(),
                 [](std::uint8_t inside) { return inside ? kUnseen : kOutside; });
  for (int layer = 0; layer < region.grid.counts.z(); ++layer) {
    add_parts_of_layer(region.grid, layer, found);
    if (layer > 0) join_with_layer_below(region.grid, layer, found);
  }
  for (LayerPart& part : found.parts) {
    part.down = part.voxels;
    for (const std::size_t lower : part.below) part.down += found.parts[lower].down;
  }
  return found;
}

}  // namespace diefill::geometry
