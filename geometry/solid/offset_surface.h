// The surface inside a solid at depth R from its boundary: where the centres of wall spheres lie.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

/// Finds places of depth R in one solid. All lengths in m.
class OffsetSurface {
 public:
  OffsetSurface(SolidQuery solid, double depth) : query_(std::move(solid)), depth_(depth) {}

  /// A place at depth R and the nearest point of the boundary.
  struct Place {
    Eigen::Vector3d centre, foot;
    Eigen::Vector3d normal() const { return (foot - centre).normalized(); }
  };

  /// The place at depth R that a first guess inside the solid leads to: never closer than R(1 - 1e-10) to the
  /// boundary. A guess too close to one or several faces is moved away from them by the shortest way (to the
  /// line at depth R below both faces of a convex edge, say); one too deep is moved towards the nearest point
  /// of the boundary. Empty when the guess is outside or the solid is too thin there. Fastest where
  /// `near_boundary` is about the point of the boundary nearest to the guess; the answer does not depend on
  /// it.
  std::optional<Place> settle(const Eigen::Vector3d& guess, const Eigen::Vector3d& near_boundary) const {
    double thickness = 0;
    return settle(guess, near_boundary, thickness, nullptr);
  }
  /// Answers on the way from a guess to its place, for reuse.
  using Trail = std::vector<SolidQuery::Known>;
  /// The same, faster where `trail` is of a guess that differs by rounding alone;
  /// fills it where it is empty.
  std::optional<Place> settle(const Eigen::Vector3d& guess, const Eigen::Vector3d& near_boundary,
                              Trail& trail) const {
    double thickness = 0;
    return settle(guess, near_boundary, thickness, &trail);
  }

  /// Places farther than this many R from the guess are another part of the tool: settle() finds none there.
  static constexpr double kFarthestMove = 12;

  /// True when `place` is inside and not closer than R to the boundary, but for rounding.
  bool is_deep_enough(const Eigen::Vector3d& place) const;

  /// Diameter of the largest ball inside the solid that touches the boundary at `surface_point` (shrinking
  /// ball, Ma, Bae and Choi 2012): the thickness of a plate. `outward_normal` is of unit length.
  double thickness(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& outward_normal) const;

  /// Distance of the two facing surfaces that leave no room at depth R where settle() failed from `guess`;
  /// empty when it did not fail for that reason.
  std::optional<double> thickness_between_opposite_faces(const Eigen::Vector3d& guess,
                                                         const Eigen::Vector3d& near_boundary) const;

  double depth() const { return depth_; }

 private:
  std::optional<Place> settle(const Eigen::Vector3d& guess, Eigen::Vector3d near_boundary, double& thickness,
                              Trail* trail) const;
  SolidQuery::Known nearest_at(const Eigen::Vector3d& place, const Eigen::Vector3d& near_boundary,
                               std::size_t step, Trail* trail) const;

  SolidQuery query_;
  double depth_;
};

}  // namespace diefill::geometry
