// Spheres and triangles in Embree: which is hit first along a ray, and whether anything is in its way.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/style/colour_map.h"

namespace diefill::render {

/// Spheres, lengths in any one unit.
struct TracedSpheres {
  std::vector<Eigen::Vector4f> spheres;  ///< centre and radius
  std::vector<Rgb> colours;              ///< one per sphere
};

/// Triangles with a normal at each corner.
struct TracedTriangles {
  std::vector<Eigen::Vector3f> corners, normals;  ///< of the same length
  std::vector<Eigen::Matrix<std::uint32_t, 3, 1>> triangles;
  std::vector<Rgb> colours;  ///< one a triangle
};

/// What a ray meets.
struct RayHit {
  float distance = 0;  ///< along the ray; infinity: nothing
  Eigen::Vector3f place = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::UnitZ();
  Rgb colour{};
  bool triangle = false;
};

/// Embree's hierarchies over one set of spheres and one of triangles. Queries may come from all
/// threads.
class RayScene {
 public:
  /// Throws std::runtime_error where Embree cannot be started or has no memory.
  RayScene(TracedSpheres spheres, TracedTriangles triangles);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first hit farther than `nearest`; its normal is turned to the side that the ray comes from.
  RayHit first_hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float nearest = 0) const;
  /// Whether there is a hit between `nearest` and `farthest`.
  bool occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float nearest,
                float farthest) const;

 private:
  struct Embree;
  void add_spheres();
  void add_triangles();

  TracedSpheres spheres_;
  TracedTriangles triangles_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace diefill::render
