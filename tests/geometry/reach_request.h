// Solids, spaces and questions of reach, lengths in mm.
#pragma once

#include "geometry/reach/reach.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {

using Eigen::Vector3d;

inline const Vector3d kUp = Vector3d::UnitZ();

inline Mesh box_mm(const Vector3d& lower, const Vector3d& upper) {
  return sample::box(lower * 1e-3, upper * 1e-3);
}

inline Box space_mm(const Vector3d& lower, const Vector3d& upper) {
  return {lower * 1e-3, upper * 1e-3};
}

inline MovingSolid standing(const Mesh& mesh, std::size_t samples = 1) {
  return {&mesh, std::vector<Eigen::Matrix3d>(samples, Eigen::Matrix3d::Identity()),
          std::vector<Vector3d>(samples, Vector3d::Zero())};
}

inline MovingSolid moving(const Mesh& mesh, const std::vector<Vector3d>& path) {
  return {&mesh, std::vector<Eigen::Matrix3d>(path.size(), Eigen::Matrix3d::Identity()), path};
}

inline bool at(const Reach& reach, std::size_t solid, const Vector3d& millimetres, const Vector3d& normal) {
  return reach.reachable(solid, millimetres * 1e-3, normal, 2e-4);
}

}  // namespace diefill::geometry
