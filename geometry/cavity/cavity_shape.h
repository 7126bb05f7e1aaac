// Measures a cavity's shape on the exact outlines of the surrounding tools: whether it is a ring, and how
// wide it is.
#pragma once

#include <optional>

#include "geometry/cavity/cavity_region.h"
#include "geometry/cavity/layer_parts.h"
#include "geometry/solid/slice_outline.h"

namespace diefill::geometry {

/// A width and where it was found, m.
struct CavityWidth {
  double width = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/// The walls of one connected part of the cavity at one height.
struct CavitySlice {
  double height = 0;                ///< m
  std::size_t part = 0;             ///< of the layer parts
  std::vector<OutlinePiece> walls;  ///< normals point into the cavity
};

/// Slices through the middle of every layer of voxels: one for each part that has walls, from below.
std::vector<CavitySlice> cavity_slices(const CavityRegion& region, const LayerParts& layers,
                                       std::span<const Mesh* const> solids);

/// The smallest horizontal distance between walls of a slice that face each other within 30 degrees, along a
/// wall's normal. Where no walls face each other (a triangle, say) it is the diameter of the largest circle
/// in the slice.
CavityWidth slice_width(const CavityRegion& region, const LayerParts& layers, const CavitySlice& slice);

/// The slices without those in the tapering ends of the cavity: the tip of a drilled hole, the bottom of a V
/// or of a bowl. Their widths fall to zero, and powder fills such an end from above as far as it fits. An end
/// is left out as far as it grows upwards by a tenth of its height on either side, up to 2 % of the cavity's
/// volume.
std::vector<CavitySlice> without_tapering_ends(const CavityRegion& region, const LayerParts& layers,
                                               std::vector<CavitySlice> slices);

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

/// The smallest width of all slices.
CavityWidth narrowest_width(const CavityRegion& region, const LayerParts& layers,
                            const std::vector<CavitySlice>& slices);

}  // namespace diefill::geometry
