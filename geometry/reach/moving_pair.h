// Whether two solids that move past each other cut into each other, pose after pose.
//
// Points of both surfaces (corners, edges and faces) are tested for their depth in the other solid. A point
// far from the other solid is not tested again before the two have moved that far relative to each other
// (conservative advancement), so many close poses cost little.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/reach/posed_solids.h"
#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

/// Mean thickness (m) of a solid: its volume over half its surface; that of a sheet is the sheet's.
double mean_thickness(const Mesh& mesh);

/// Two solids and their known distances.
class MovingPair {
 public:
  /// Depths up to `tolerance` (m) are tight fits, facets and rounding. Keeps references to all four.
  MovingPair(const Mesh& one, const SolidQuery& solid_of_one, const Mesh& other,
             const SolidQuery& solid_of_other, double tolerance);

  /// The deepest place where one is in the other.
  struct Cut {
    double depth = 0;                                 ///< m
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, laboratory frame
  };
  /// Nothing if they cut no deeper than the tolerance in these poses.
  std::optional<Cut> find_cut(const SolidPose& one, const SolidPose& other);

 private:
  struct Side {
    std::vector<Eigen::Vector3d> points;  ///< m, of the surface, in the solid's own frame
    std::vector<double> free_until;       ///< m travelled, for each point: not too deep before
    Box box;                              ///< of the points
    const SolidQuery* into = nullptr;     ///< the other solid
    double travelled = 0;                 ///< m, since the first pose
    std::optional<SolidPose> last;        ///< in the other's frame
  };
  static Side side(const Mesh& mesh, const SolidQuery& into);
  void find_cut_from(Side& side, const SolidPose& own, const SolidPose& other,
                     std::optional<Cut>& deepest) const;

  double tolerance_;
  std::array<Side, 2> sides_;
};

}  // namespace diefill::geometry
