// The growing set of wall sphere centres: which candidates become centres, and the regular grids and rows
// tried first.
#pragma once

#include <functional>
#include <optional>

#include "geometry/grids/point_grid.h"
#include "geometry/solid/offset_surface.h"
#include "geometry/solid/surface_strips.h"

namespace diefill::geometry {

/// Centres at depth R on a surface, and the rule by which guesses join them. Lengths in m.
class WallLayout {
 public:
  /// `wanted(foot)` says whether a sphere touching the surface at `foot` is of use.
  WallLayout(const OffsetSurface& offset, double spacing,
             std::function<bool(const Eigen::Vector3d& foot)> wanted);

  /// Settles `guess` at depth R and adds it unless a centre lies nearer than `least_distance`. Returns the
  /// new centre.
  std::optional<OffsetSurface::Place> add(const Eigen::Vector3d& guess, const Eigen::Vector3d& foot,
                                          double least_distance);

  /// A square grid fitted to the strip: its outermost rows lie on the strip's ends, spacings are at most the
  /// wanted one. Its points keep their distance from what is there already.
  void add_grid(const Strip& strip);

  const PointGrid& centres() const { return centres_; }
  const OffsetSurface& offset() const { return offset_; }
  double spacing() const { return spacing_; }
  bool wanted(const Eigen::Vector3d& foot) const { return wanted_(foot); }

  /// Guesses nearer to a centre than this part of the spacing do not become centres.
  static constexpr double kMinDistance = 0.7;

 private:
  /// Where the guess settles; none where no sphere is of use. Several threads may ask at once.
  std::optional<OffsetSurface::Place> settled(const Eigen::Vector3d& guess,
                                              const Eigen::Vector3d& foot) const;
  /// Adds a settled place as add() does.
  std::optional<OffsetSurface::Place> keep(const std::optional<OffsetSurface::Place>& place,
                                           double least_distance);

  const OffsetSurface& offset_;
  double spacing_;
  std::function<bool(const Eigen::Vector3d&)> wanted_;
  PointGrid centres_;
};

}  // namespace diefill::geometry
