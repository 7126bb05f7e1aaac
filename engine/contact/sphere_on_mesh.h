// Where spheres touch a tool of triangles. A contact is a place where the surface is nearest to the sphere's
// centre, that is, nearer than all of the surface round about: the inside of a face, an edge or a corner that
// stands out. A triangle whose nearest point lies on a seam to the next, which comes nearer still, is none:
// faces go before edges and edges before corners, and what several triangles share counts once. A flat face
// of many triangles is then as flat as one, a groove is touched on both sides.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/numerics/vector3.h"
#include "engine/walls/walls.h"

namespace diefill::engine {

/// Centre (m, body frame) of a sphere of `radius` (m) at `place` seen from the point of triangle `part` that
/// it touches. For a centre behind the triangle: outwards, by almost nothing, so that it is pushed back.
Eigen::Vector3d separation_from_triangle(const WallBody& body, std::uint32_t part,
                                         const Eigen::Vector3d& place, double radius);

/// Whether directions `a` and `b` (of any length) differ by less than facets of one surface do (15 degrees).
bool same_direction(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Where a triangle that a sphere overlaps, or nearly so, comes nearest to its centre.
struct TriangleFoot {
  std::uint32_t near, part;  ///< numbers of the near pair and of the triangle
  NearestPoint point;
  double distance;  ///< m, from the sphere's centre
  double height;    ///< m, of the centre over the triangle's plane
};

/// A contact of a sphere with a triangle.
struct TriangleTouch {
  std::uint32_t near;  ///< number of the near pair
  Vector3 separation;  ///< m, body frame, of the sphere's centre from where it touches
};

/// Memory to work in, whatever it holds.
struct MeshWorkspace {
  std::vector<TriangleFoot> feet;         ///< of one sphere
  std::vector<const TriangleFoot*> kept;  ///< those where it touches
  std::vector<TriangleTouch> touches;     ///< of one sphere
  std::vector<std::uint8_t> touches_now;  ///< of the near pairs of one sphere
};

/// One sphere, the triangles of one body that it overlaps, and which of them it touches in their own right.
/// Facets of one curved surface meet at angles below 15 degrees: of contacts whose normals differ by less
/// only the deepest counts, or every seam of a hollow would push twice.
class SphereOnMesh {
 public:
  /// `place`: of the centre (m, body frame); `radius` in m.
  SphereOnMesh(MeshWorkspace& workspace, const WallBody& body, const Eigen::Vector3d& place, double radius);

  const WallBody& body() const { return body_; }
  const Eigen::Vector3d& place() const { return place_; }
  double radius() const { return radius_; }
  /// m from the centre, within which triangles matter: beyond the radius, as the face at an edge may be
  /// farther than the edge of the next by a step of the CAD.
  double reach() const { return radius_ + equally_near_; }

  /// Tests triangle `part` of near pair `near`; numbers rise from call to call.
  void add_triangle(std::uint32_t near, std::uint32_t part);
  /// The contacts, the deepest first, until the workspace is used again.
  std::span<const TriangleTouch> touches();
  /// m, overlap of the deepest contact, after touches(); beyond the radius where the centre has come behind
  /// the surface.
  double deepest() const { return deepest_; }

 private:
  void keep_nearest();
  Eigen::Vector3d separation(const TriangleFoot& foot) const;
  bool at_same_place(const TriangleFoot& one, const TriangleFoot& other) const;
  bool is_behind(const TriangleFoot& nearest) const;
  bool is_nearest_around(const TriangleFoot& foot) const;
  bool reaches(std::uint32_t part, const Eigen::Vector3d& point) const;

  MeshWorkspace& workspace_;
  const WallBody& body_;
  Eigen::Vector3d place_;
  double radius_, tolerance_, equally_near_, deepest_ = 0;  ///< m
};

/// Notes in `table` which of the near pairs [begin, end), all of `sphere` with its body, touch now. The
/// history of a contact follows it from triangle to triangle: one that begins while another of the same
/// sphere ends, in about the same direction, goes on from there.
///
/// `Table`: PairTable or one like it; part_of(its pair) gives the triangle.
template <class Table>
void note_triangle_touches(Table& table, const SphereOnMesh& sphere, std::uint32_t begin, std::uint32_t end,
                           std::span<const TriangleTouch> touches, std::vector<std::uint8_t>& now) {
  now.assign(end - begin, 0);
  for (const auto& touch : touches) now[touch.near - begin] = 1;
  const auto ended_contact_like = [&](const Eigen::Vector3d& way) {
    std::uint32_t best = end;
    double nearest = 0;
    for (std::uint32_t p = begin; p < end; ++p) {
      if (!table.touching[p] || now[p - begin]) continue;
      const Eigen::Vector3d earlier =
          separation_from_triangle(sphere.body(), part_of(table.pair[p]), sphere.place(), sphere.radius());
      const double apart = (earlier - way).squaredNorm();
      if (!same_direction(earlier, way) || (best != end && apart >= nearest)) continue;
      best = p;
      nearest = apart;
    }
    return best;
  };
  for (const auto& touch : touches) {
    if (table.touching[touch.near]) continue;
    const std::uint32_t before = ended_contact_like(eigen(touch.separation));
    std::fill_n(table.history_of(touch.near), table.width, 0.0);
    if (before == end) continue;
    std::copy_n(table.history_of(before), table.width, table.history_of(touch.near));
    table.touching[before] = 0;
  }
  std::copy(now.begin(), now.end(), table.touching.begin() + begin);
}

}  // namespace diefill::engine
