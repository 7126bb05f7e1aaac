// Measures a cavity's shape on the exact outlines of the surrounding tools: whether it is a ring, and how
// wide it is.
#pragma once

#include <optional>

#include "geometry/cavity/cavity_region.h"
#include "geometry/solid/slice_outline.h"

namespace diefill::geometry {

/// The walls of the cavity at one height.
struct CavitySlice {
  double height = 0;                ///< m
  int layer = 0;                    ///< of the region's grid
  std::vector<OutlinePiece> walls;  ///< normals point into the cavity
};

/// One slice through the middle of every layer of voxels that the cavity has walls in, from below.
std::vector<CavitySlice> cavity_slices(const CavityRegion& region, std::span<const Mesh* const> solids);

/// A width and where it was found, m.
struct CavityWidth {
  double width = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/// Concentric circles fitted to all slices, m.
struct CavityRing {
  Eigen::Vector2d axis = Eigen::Vector2d::Zero();
  double inner_radius = 0;  ///< smallest over the height
  double outer_radius = 0;  ///< largest over the height
  CavityWidth narrowest;
};

/// The ring that the slices form; nothing unless in every slice all walls lie within half of `tolerance` (m)
/// of two circles about one axis.
std::optional<CavityRing> fit_ring(const std::vector<CavitySlice>& slices, double tolerance);

/// The smallest horizontal distance between walls that face each other within 30 degrees, along a wall's
/// normal. Where no walls face each other (a triangle, say) it is the diameter of the largest circle in the
/// slice.
CavityWidth narrowest_width(const CavityRegion& region, const std::vector<CavitySlice>& slices);

}  // namespace diefill::geometry
