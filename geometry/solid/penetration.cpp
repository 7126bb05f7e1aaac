#include "geometry/solid/penetration.h"

#include <algorithm>
#include <array>
#include <vector>

namespace diefill::geometry {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

bool overlaps(const Corners& corners, const Box& box) {
  for (int k = 0; k < 3; ++k) {
    const auto [least, most] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
    if (most < box.lower[k] || least > box.upper[k]) return false;
  }
  return true;
}

Eigen::Vector3d middle_of(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3;
}

/// How far the triangle reaches from its middle, m.
double reach_of(const Corners& corners, const Eigen::Vector3d& middle) {
  double reach = 0;
  for (const auto& corner : corners) reach = std::max(reach, (corner - middle).norm());
  return reach;
}

/// The two halves of a triangle cut through its longest side.
std::array<Corners, 2> halves(const Corners& corners) {
  int longest = 0;  // the side that begins at this corner
  for (int k = 1; k < 3; ++k)
    if ((corners[(k + 1) % 3] - corners[k]).squaredNorm() >
        (corners[(longest + 1) % 3] - corners[longest]).squaredNorm())
      longest = k;
  const Eigen::Vector3d &start = corners[longest], &end = corners[(longest + 1) % 3];
  const Eigen::Vector3d &opposite = corners[(longest + 2) % 3], middle = (start + end) / 2;
  return {Corners{start, middle, opposite}, Corners{middle, end, opposite}};
}

class Search {
 public:
  Search(const SolidQuery& solid, const Box& box, double resolution)
      : solid_(solid), box_(box), resolution_(resolution) {}

  void visit(const Eigen::Vector3d& point) {
    if (box_.contains(point)) deepen(point);
  }

  /// A triangle whose corners have been visited.
  void visit(const Corners& triangle) {
    if (reach_of(triangle, middle_of(triangle)) <= resolution_) return;  // no point is farther from a corner
    open_.push_back(triangle);
    while (!open_.empty()) {
      const Corners corners = open_.back();
      open_.pop_back();
      if (!overlaps(corners, box_)) continue;
      const Eigen::Vector3d middle = middle_of(corners);
      const double reach = reach_of(corners, middle);
      const double depth = deepen(middle);
      if (reach <= resolution_ || depth + reach <= deepest_.depth + resolution_) continue;
      for (const Corners& half : halves(corners)) open_.push_back(half);
    }
  }

  const Penetration& deepest() const { return deepest_; }

 private:
  /// Depth of the point, negative outside.
  double deepen(const Eigen::Vector3d& point) {
    const double depth = -solid_.signed_distance(point);
    if (depth > deepest_.depth) deepest_ = {depth, point};
    return depth;
  }

  const SolidQuery& solid_;
  Box box_;
  double resolution_;
  Penetration deepest_;
  std::vector<Corners> open_;
};

}  // namespace

Penetration deepest_penetration(const Mesh& part, const SolidQuery& solid, const Box& box,
                                double resolution) {
  Search search(solid, box, resolution);
  for (const auto& vertex : part.vertices) search.visit(vertex);
  for (const auto& triangle : part.triangles)
    search.visit({part.vertices[triangle[0]], part.vertices[triangle[1]], part.vertices[triangle[2]]});
  return search.deepest();
}

}  // namespace diefill::geometry
