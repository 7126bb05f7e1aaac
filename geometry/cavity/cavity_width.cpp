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

CavityWidth largest_circle(const CavityRegion& region, const CavitySlice& slice) {
  const auto& grid = region.grid;
  const Eigen::Vector2d voxels = (region.box.size() / grid.edge).head<2>();
  const int stride = std::max(1, static_cast<int>(std::sqrt(voxels.prod() / kCirclesASlice)));
  CavityWidth largest;
  for (int j = 0; j < grid.counts.y(); j += stride) {
    for (int i = 0; i < grid.counts.x(); i += stride) {
      if (!region.inside[grid.index(i, j, slice.layer)]) continue;
      const Eigen::Vector3d centre = grid.centre({i, j, slice.layer});
      double radius = 1e300;
      for (const auto& wall : slice.walls) radius = std::min(radius, distance_to(wall, centre.head<2>()));
      if (2 * radius > largest.width) largest = {2 * radius, centre};
    }
  }
  return largest;
}

CavityWidth slice_width(const CavityRegion& region, const CavitySlice& slice) {
  CavityWidth narrowest{1e300, {}};
  for (const auto& wall : slice.walls) {
    const auto distance = facing_distance(wall, slice.walls);
    if (!distance || *distance >= narrowest.width) continue;
    const Eigen::Vector2d place = wall.middle() + wall.normal * *distance / 2;
    narrowest = {*distance, {place.x(), place.y(), slice.height}};
  }
  return narrowest.width < 1e300 ? narrowest : largest_circle(region, slice);
}

// A voxel's edge in front of the wall one is in the cavity. Walls inside other tools have solid there.
bool borders(const CavityRegion& region, const OutlinePiece& wall, double height) {
  const Eigen::Vector2d front = wall.middle() + wall.normal * region.grid.edge;
  const Eigen::Vector3i voxel = region.grid.voxel_at({front.x(), front.y(), height});
  return region.grid.has(voxel) && region.inside[region.grid.index(voxel.x(), voxel.y(), voxel.z())] != 0;
}

}  // namespace

std::vector<CavitySlice> cavity_slices(const CavityRegion& region, std::span<const Mesh* const> solids) {
  std::vector<CavitySlice> slices;
  for (int k = 0; k < region.grid.counts.z(); ++k) {
    CavitySlice slice{region.grid.centre({0, 0, k}).z(), k, {}};
    if (slice.height < region.box.lower.z()) continue;
    for (const auto* solid : solids) {
      for (const auto& wall : slice_outline(*solid, slice.height, kLongestPiece)) {
        if (borders(region, wall, slice.height)) slice.walls.push_back(wall);
      }
    }
    if (!slice.walls.empty()) slices.push_back(std::move(slice));
  }
  return slices;
}

CavityWidth narrowest_width(const CavityRegion& region, const std::vector<CavitySlice>& slices) {
  CavityWidth narrowest{1e300, {}};
  for (const auto& slice : slices) {
    const auto width = slice_width(region, slice);
    if (width.width > 0 && width.width < narrowest.width) narrowest = width;
  }
  return narrowest.width < 1e300 ? narrowest : CavityWidth{};
}

}  // namespace diefill::geometry
