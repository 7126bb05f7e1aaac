#include "engine/powder/grain_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

#include "engine/powder/sphere_volume.h"

namespace diefill::engine {

namespace {

std::vector<Eigen::Vector3d> octahedron(double distance) {
  std::vector<Eigen::Vector3d> corners;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-distance, distance}) corners.push_back(side * Eigen::Vector3d::Unit(axis));
  return corners;
}

/// Inertia tensor about the origin: spheres of mass `mass` each at `offsets`, self term 2/5 m R^2 included
/// (OP-6).
Eigen::Matrix3d inertia_tensor(const std::vector<Eigen::Vector3d>& offsets, double radius, double mass) {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const auto& b : offsets) {
    tensor += mass * (b.squaredNorm() * Eigen::Matrix3d::Identity() - b * b.transpose());
    tensor += 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity();
  }
  return tensor;
}

/// Volume of the union of six unit spheres at +-e over that of one, by quadrature on a grid.
constexpr double kUnionOfModelC = 4.7926;

GrainShape single_sphere(double radius, double mass, bool rotates) {
  GrainShape shape = rigid_grain(radius, {Eigen::Vector3d::Zero()}, mass, sphere_volume(radius));
  shape.rotates = rotates;
  return shape;
}

}  // namespace

double GrainShape::bounding_radius() const {
  double farthest = 0;
  if (sphere_radii.empty()) {
    for (const auto& offset : sphere_offsets) farthest = std::max(farthest, offset.norm());
    return farthest + sphere_radius;
  }
  for (std::size_t k = 0; k < spheres(); ++k)
    farthest = std::max(farthest, sphere_offsets[k].norm() + sphere_radii[k]);
  return farthest;
}

GrainShape model_a(double sphere_radius, double mass) {
  return single_sphere(sphere_radius, mass, false);
}

GrainShape model_b(double sphere_radius, double mass) {
  return single_sphere(sphere_radius, mass, true);
}

GrainShape model_c(double sphere_radius, double mass) {
  return rigid_grain(sphere_radius, octahedron(sphere_radius), mass,
                     kUnionOfModelC * sphere_volume(sphere_radius));
}

GrainShape model_d(double sphere_radius, double mass) {
  auto offsets = octahedron(2 * sphere_radius);
  offsets.insert(offsets.begin(), Eigen::Vector3d::Zero());
  return rigid_grain(sphere_radius, std::move(offsets), mass, 7 * sphere_volume(sphere_radius));
}

GrainShape rigid_grain(double sphere_radius, std::vector<Eigen::Vector3d> offsets, double mass,
                       double solid_volume) {
  if (offsets.empty()) throw std::invalid_argument("a grain needs at least one sphere");
  if (!(sphere_radius > 0 && mass > 0 && solid_volume > 0))
    throw std::invalid_argument("radius, mass and solid volume of a grain must be positive");
  const auto count = static_cast<double>(offsets.size());
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto& offset : offsets) centre += offset / count;
  for (auto& offset : offsets) offset -= centre;

  const Eigen::Matrix3d tensor = inertia_tensor(offsets, sphere_radius, mass / count);
  GrainShape shape;
  shape.inertia = tensor.diagonal();
  const double off_diagonal = (tensor - Eigen::Matrix3d(tensor.diagonal().asDiagonal())).norm();
  if (off_diagonal > 1e-12 * tensor.norm()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor);
    Eigen::Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) *= -1;
    for (auto& offset : offsets) offset = axes.transpose() * offset;
    shape.inertia = principal.eigenvalues();
  }
  shape.sphere_radius = sphere_radius;
  shape.sphere_offsets = std::move(offsets);
  shape.mass = mass;
  shape.solid_volume = solid_volume;
  return shape;
}

}  // namespace diefill::engine
