// Where spheres touch a tool of triangles. A contact is a place where the surface is nearest to the sphere's
// centre, that is, nearer than all of the surface round about: the inside of a face, an edge or a corner that
// stands out. A triangle whose nearest point lies on a seam to the next, which comes nearer still, is none:
// faces go before edges and edges before corners, and what several triangles share counts once. A flat face
// of many triangles is then as flat as one, a groove is touched on both sides.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/local_spheres.h"
#include "engine/search/pair_table.h"
#include "engine/walls/walls.h"

namespace diefill::engine {

/// Centre (m, body frame) of a sphere of `radius` (m) at `place` seen from the point of triangle `part` that
/// it touches. For a centre behind the triangle: outwards, by almost nothing, so that it is pushed back.
Eigen::Vector3d separation_from_triangle(const WallBody& body, std::uint32_t part,
                                         const Eigen::Vector3d& place, double radius);

/// A touching pair with a wall, seen in the body's frame.
struct WallTouch {
  std::uint32_t pair, sphere_class;  ///< of the pair's sphere, 0 where there is one
  Vector3 separation;                ///< m, grain sphere from wall sphere, plane or triangle
};

/// A block's near pairs with one body of triangles, and where all is.
struct MeshPairs {
  const Block& block;
  std::size_t number;  ///< of the body
  const WallBody& body;
  const BodyMotion& pose;
  const LocalSpheres& spheres;
  const std::vector<double>& radii;  ///< m, of the classes of spheres

  std::uint32_t begin() const { return block.wall_first[number]; }
  std::uint32_t end() const { return block.wall_first[number + 1]; }
  std::uint32_t class_of(LocalSphere sphere) const {
    return block.sphere_class.empty() ? 0 : block.sphere_class[sphere];
  }
  double radius_of(LocalSphere sphere) const { return radii[class_of(sphere)]; }
  /// m, body frame.
  Eigen::Vector3d place_of(LocalSphere sphere) const {
    return pose.rotation.transpose() * (eigen(spheres.position(sphere)) - pose.translation);
  }
};

/// Where a triangle that a sphere overlaps comes nearest to its centre.
struct TriangleFoot {
  std::uint32_t near, part;  ///< numbers of the pair in its run and of the triangle
  NearestPoint point;
  double distance;  ///< m, from the sphere's centre
  double height;    ///< m, of the centre over the triangle's plane
};

/// Memory to work in, whatever it holds.
struct MeshWorkspace {
  std::vector<TriangleFoot> feet;         ///< of one sphere
  std::vector<const TriangleFoot*> kept;  ///< those where it touches
  std::vector<std::uint8_t> touches_now;  ///< of the body's pairs
};

/// Deepest overlap of spheres with a body.
struct DeepestOnMesh {
  double overlap = 0;      ///< m; beyond the radius where a centre has come behind the surface
  double over_radius = 0;  ///< over the sphere's radius
};

/// Appends the pairs that touch, sphere after sphere. A function of places alone.
///
/// Facets of one curved surface meet at angles below 15 degrees: of contacts whose normals differ by less
/// only the deepest counts, or every seam of a hollow would push twice.
DeepestOnMesh find_mesh_touches(const MeshPairs& near, MeshWorkspace& workspace,
                                std::vector<WallTouch>& touches);

/// Notes in the block's `table` which pairs touch now. What a contact remembers follows it from triangle to
/// triangle: one that begins while another of the same sphere ends, in about the same direction, goes on from
/// there.
void note_mesh_touches(PairTable<WallPair>& table, const MeshPairs& near,
                       const std::vector<WallTouch>& touches, MeshWorkspace& workspace);

}  // namespace diefill::engine
