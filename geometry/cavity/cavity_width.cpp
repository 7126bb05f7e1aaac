#include <algorithm>
#include <cmath>

#include "geometry/cavity/cavity_shape.h"

namespace diefill::geometry {
namespace {

constexpr double kLongestPiece = 1e-3;
const double kFacing = -std::cos(0.5235987755982988);  // 30 degrees
constexpr int kCirclesASlice = 1000;                   // tried as the largest circle, at most about so many

double cross(const Eigen::Vector2d& one, const Eigen::Vector2d& other) {
  return one.x() * other.y() - one.y() * other.x();
}

// Distance along the ray from `origin` to a wall; nothing behind or beside.
std::optional<double> hit(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                          const OutlinePiece& wall) {
  const Eigen::Vector2d along = wall.to - wall.from;
  const double denominator = cross(direction, along);
  if (std::abs(denominator) < 1e-12 * along.norm()) return std::nullopt;
  const Eigen::Vector2d offset = wall.from - origin;
  const double distance = cross(offset, along) / denominator;
  const double part = cross(offset, direction) / denominator;
  if (distance <= 1e-9 || part < 0 || part > 1) return std::nullopt;
  return distance;
}

// The first wall a ray from the middle of `start` along its normal meets, if that wall faces it.
std::optional<double> facing_distance(const OutlinePiece& start, const std::vector<OutlinePiece>& walls) {
  std::optional<double> nearest;
  bool faces = false;
  for (const auto& wall : walls) {
    if (wall.normal.dot(start.normal) >= 0) continue;
    const auto distance = hit(start.middle(), start.normal, wall);
    if (!distance || (nearest && *nearest <= *distance)) continue;
    nearest = distance;
    faces = wall.normal.dot(start.normal) <= kFacing;
  }
  return faces ? nearest : std::nullopt;
}

double distance_to(const OutlinePiece& wall, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = wall.to - wall.from;
  const double part = std::clamp((point - wall.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - wall.from - part * along).norm();
}

CavityWidth largest_circle(const CavityRegion& region, const LayerParts& layers, const CavitySlice& slice) {
  const auto& grid = region.grid;
  const Eigen::Vector2d voxels = (region.box.size() / grid.edge).head<2>();
  const int stride = std::max(1, static_cast<int>(std::sqrt(voxels.prod() / kCirclesASlice)));
  const int layer = layers.parts[slice.part].layer;
  CavityWidth largest;
  for (int j = 0; j < grid.counts.y(); j += stride) {
    for (int i = 0; i < grid.counts.x(); i += stride) {
      if (layers.part_at[grid.index(i, j, layer)] != static_cast<std::int32_t>(slice.part)) continue;
      const Eigen::Vector3d centre = grid.centre({i, j, layer});
      double radius = 1e300;
      for (const auto& wall : slice.walls) radius = std::min(radius, distance_to(wall, centre.head<2>()));
      if (2 * radius > largest.width) largest = {2 * radius, centre};
    }
  }
  return largest;
}

// The part whose voxel lies a voxel's edge in front of the wall. Walls inside other tools have solid there.
std::optional<std::size_t> part_at_wall(const VoxelGrid& grid, const LayerParts& layers,
                                        const OutlinePiece& wall, double height) {
  const Eigen::Vector2d front = wall.middle() + wall.normal * grid.edge;
  const Eigen::Vector3i voxel = grid.voxel_at({front.x(), front.y(), height});
  if (!grid.has(voxel)) return std::nullopt;
  const std::int32_t part = layers.part_at[grid.index(voxel.x(), voxel.y(), voxel.z())];
  if (part < 0) return std::nullopt;
  return static_cast<std::size_t>(part);
}

// Follows the ends upwards: a part belongs to one if all below it does, and it is narrower than what lies on
// it.
class TaperingEnds {
 public:
  TaperingEnds(const CavityRegion& region, const LayerParts& layers, const std::vector<CavitySlice>& slices)
      : layers_(layers), widths_(layers.parts.size(), 0.0), tapers_(layers.parts.size(), false) {
    std::size_t all = 0;
    for (const LayerPart& part : layers.parts) all += part.voxels;
    const auto most = static_cast<std::size_t>(kLargestEnd * static_cast<double>(all));
    for (const CavitySlice& slice : slices)
      if (is_end_or_lies_on_one(slice.part, most))
        widths_[slice.part] = slice_width(region, layers, slice).width;
    for (std::size_t k = 0; k < layers.parts.size(); ++k) tapers_[k] = tapers(k, most, region.grid.edge);
  }
  bool hold(const CavitySlice& slice) const { return tapers_[slice.part]; }

 private:
  static constexpr double kLargestEnd = 0.02;  // of the cavity's volume
  static constexpr double kGrowth = 0.2;       // of the height, in width, from which on walls taper

  bool is_end_or_lies_on_one(std::size_t k, std::size_t most) const {
    const LayerPart& part = layers_.parts[k];
    return part.down <= most || std::any_of(part.below.begin(), part.below.end(), [&](std::size_t lower) {
             return layers_.parts[lower].down <= most;
           });
  }
  bool tapers(std::size_t k, std::size_t most, double edge) const {
    const LayerPart& part = layers_.parts[k];
    if (part.down > most || !part.above) return false;
    for (const std::size_t lower : part.below)
      if (!tapers_[lower]) return false;
    return widths_[*part.above] > widths_[k] + kGrowth * edge;
  }

  const LayerParts& layers_;
  std::vector<double> widths_;  // m, by part; 0 where it has no walls
  std::vector<bool> tapers_;
};

}  // namespace

CavityWidth slice_width(const CavityRegion& region, const LayerParts& layers, const CavitySlice& slice) {
  CavityWidth narrowest{1e300, {}};
  for (const auto& wall : slice.walls) {
    const auto distance = facing_distance(wall, slice.walls);
    if (!distance || *distance >= narrowest.width) continue;
    const Eigen::Vector2d place = wall.middle() + wall.normal * *distance / 2;
    narrowest = {*distance, {place.x(), place.y(), slice.height}};
  }
  return narrowest.width < 1e300 ? narrowest : largest_circle(region, layers, slice);
}

std::vector<CavitySlice> cavity_slices(const CavityRegion& region, const LayerParts& layers,
                                       std::span<const Mesh* const> solids) {
  std::vector<CavitySlice> slices(layers.parts.size());
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].part = k;
    slices[k].height = region.grid.centre({0, 0, layers.parts[k].layer}).z();
  }
  for (int layer = 0; layer < region.grid.counts.z(); ++layer) {
    const double height = region.grid.centre({0, 0, layer}).z();
    if (height < region.box.lower.z()) continue;
    for (const auto* solid : solids)
      for (const auto& wall : slice_outline(*solid, height, kLongestPiece))
        if (const auto part = part_at_wall(region.grid, layers, wall, height))
          slices[*part].walls.push_back(wall);
  }
  std::erase_if(slices, [](const CavitySlice& slice) { return slice.walls.empty(); });
  return slices;
}

std::vector<CavitySlice> without_tapering_ends(const CavityRegion& region, const LayerParts& layers,
                                               std::vector<CavitySlice> slices) {
  const TaperingEnds ends(region, layers, slices);
  std::erase_if(slices, [&](const CavitySlice& slice) { return ends.hold(slice); });
  return slices;
}

CavityWidth narrowest_width(const CavityRegion& region, const LayerParts& layers,
                            const std::vector<CavitySlice>& slices) {
  CavityWidth narrowest{1e300, {}};
  for (const auto& slice : slices) {
    const auto width = slice_width(region, layers, slice);
    if (width.width > 0 && width.width < narrowest.width) narrowest = width;
  }
  return narrowest.width < 1e300 ? narrowest : CavityWidth{};
}

}  // namespace diefill::geometry
