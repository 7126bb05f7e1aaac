// A triangle mesh in metres: the surface of one CAD tool.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <vector>

namespace diefill::geometry {

/// A CAD file or mesh that cannot be used. The message is one line for people: file, finding, what to do.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Axis-aligned box, m.
struct Box {
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d upper = Eigen::Vector3d::Constant(-1e300);
  void include(const Eigen::Vector3d& point);
  void include(const Box& other);
  bool contains(const Eigen::Vector3d& point) const;
  Eigen::Vector3d size() const { return upper - lower; }
};

/// Vertices (m) and triangles (vertex indices, counter-clockwise seen from outside the solid).
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;

  Box bounding_box() const;
  /// Enclosed volume in m^3 by the divergence theorem; meaningful for closed, oriented meshes; negative if
  /// inside out.
  double volume() const;
};

/// The mesh turned by `rotation` (a rotation matrix), then shifted by `translation` (m).
Mesh transformed(const Mesh& mesh, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation);

}  // namespace diefill::geometry
