// Distance, nearest point and inside/outside queries of a closed mesh, in double precision.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle_tree.h"

namespace diefill::geometry {

struct Topology;

/// Geometric queries of one closed, outward mesh. Building costs O(n log n), a query O(log n).
/// Thread-safe. Copies share what was built:
/// 150 bytes per triangle.
class SolidQuery {
 public:
  /// Throws MeshError for a mesh without a triangle that has an area.
  explicit SolidQuery(const Mesh& mesh);
  /// The same for a mesh whose adjacency is known.
  SolidQuery(const Mesh& mesh, Topology topology);

  struct Nearest {
    Eigen::Vector3d point;  ///< m, on the surface
    double distance;        ///< m, not negative
    std::size_t triangle;
  };
  Nearest nearest(const Eigen::Vector3d& point) const;
  struct SignedNearest : Nearest {
    bool inside;  ///< the query point is inside the solid
  };
  /// Both answers for the cost of one.
  SignedNearest signed_nearest(const Eigen::Vector3d& point) const;
  /// The answer for a point, kept for near ones.
  struct Known : SignedNearest {
    Eigen::Vector3d query_point;
    std::uint32_t tree_triangle;  ///< number in tree()
    bool alone;                   ///< TriangleTree::Hit::alone
  };
  /// The same, faster where the surface is within `guess` (m) of the point or little farther.
  Known signed_nearest(const Eigen::Vector3d& point, double guess) const;
  /// The same, fastest where `known` is of a point that differs by rounding alone.
  Known signed_nearest(const Eigen::Vector3d& point, const Known& known) const;
  bool inside(const Eigen::Vector3d& point) const;
  /// Distance to the surface in m, negative inside the solid.
  double signed_distance(const Eigen::Vector3d& point) const;
  /// Of the mesh.
  const Topology& topology() const;
  /// The triangles that count: none without area, none twice.
  const TriangleTree& tree() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace diefill::geometry
