// Contacts of a block of grains with a tool of triangles; sphere_on_mesh.h says what a contact is.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/local_spheres.h"
#include "engine/contact/sphere_on_mesh.h"
#include "engine/search/pair_table.h"
#include "engine/walls/walls.h"

namespace diefill::engine {

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

  std::uint32_t class_of(LocalSphere sphere) const {
    return block.sphere_class.empty() ? 0 : block.sphere_class[sphere];
  }
  double radius_of(LocalSphere sphere) const { return radii[class_of(sphere)]; }
  /// m, body frame.
  Eigen::Vector3d place_of(LocalSphere sphere) const {
    return pose.rotation.transpose() * (eigen(spheres.position(sphere)) - pose.translation);
  }
};

/// Deepest overlap of spheres with a body.
struct DeepestOnMesh {
  double overlap = 0;      ///< m; beyond the radius where a centre has come behind the surface
  double over_radius = 0;  ///< over the sphere's radius
};

/// Appends the pairs that touch, sphere after sphere. A function of places alone.
DeepestOnMesh find_mesh_touches(const MeshPairs& near, MeshWorkspace& workspace,
                                std::vector<WallTouch>& touches);
/// The same, and notes in `table`, the block's, which pairs touch now and the history of new ones.
DeepestOnMesh update_mesh_touches(PairTable<WallPair>& table, const MeshPairs& near, MeshWorkspace& workspace,
                                  std::vector<WallTouch>& touches);

}  // namespace diefill::engine
