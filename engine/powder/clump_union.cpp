#include "engine/powder/clump_union.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::engine {

namespace {

/// Lines of the grid across the longer side of the union.
constexpr int kLines = 300;

/// Integrals over a body, about the origin of its frame: of 1, of places and of their products.
struct Moments {
  double volume = 0;                                 ///< m^3
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< m^4
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< m^5

  /// A rod of cross-section `area` (m^2) along z from `low` to `high` (m) at x, y.
  void add_rod(double x, double y, double low, double high, double area) {
    const double length = high - low, middle = 0.5 * (low + high);
    const Eigen::Vector3d place(x, y, middle);
    const double volume_of_rod = area * length;
    volume += volume_of_rod;
    first += volume_of_rod * place;
    second += volume_of_rod * place * place.transpose();
    second(0, 0) += volume_of_rod * area / 12;
    second(1, 1) += volume_of_rod * area / 12;
    second(2, 2) += volume_of_rod * length * length / 12;
  }
};

/// Adds what lies in any of the spheres on the line along z through x, y.
void add_line(const std::vector<ClumpSphere>& spheres, double x, double y, double area, Moments& moments) {
  std::vector<std::pair<double, double>> inside;
  for (const ClumpSphere& sphere : spheres) {
    const double squared = sphere.radius * sphere.radius - std::pow(x - sphere.centre.x(), 2) -
                           std::pow(y - sphere.centre.y(), 2);
    if (squared <= 0) continue;
    const double half = std::sqrt(squared);
    inside.emplace_back(sphere.centre.z() - half, sphere.centre.z() + half);
  }
  std::sort(inside.begin(), inside.end());
  for (std::size_t k = 0; k < inside.size();) {
    const double low = inside[k].first;
    double high = inside[k].second;
    for (++k; k < inside.size() && inside[k].first <= high; ++k) high = std::max(high, inside[k].second);
    moments.add_rod(x, y, low, high, area);
  }
}

Moments moments_of(const std::vector<ClumpSphere>& spheres) {
  Eigen::Vector2d lower = Eigen::Vector2d::Constant(1e300), upper = -lower;
  for (const ClumpSphere& sphere : spheres) {
    lower = lower.cwiseMin((sphere.centre.head<2>().array() - sphere.radius).matrix());
    upper = upper.cwiseMax((sphere.centre.head<2>().array() + sphere.radius).matrix());
  }
  const double step = (upper - lower).maxCoeff() / kLines;
  Moments moments;
  for (double y = lower.y() + 0.5 * step; y < upper.y(); y += step)
    for (double x = lower.x() + 0.5 * step; x < upper.x(); x += step)
      add_line(spheres, x, y, step * step, moments);
  return moments;
}

void check(const std::vector<ClumpSphere>& spheres, double density) {
  if (spheres.empty()) throw std::invalid_argument("a clump needs at least one sphere");
  if (!(density > 0)) throw std::invalid_argument("the density of a clump must be positive");
  for (const ClumpSphere& sphere : spheres)
    if (!(sphere.radius > 0) || !sphere.centre.allFinite())
      throw std::invalid_argument("a sphere of a clump needs a finite centre and a positive radius");
}

}  // namespace

GrainShape grain_of_union(const std::vector<ClumpSphere>& spheres, double density) {
  check(spheres, density);
  const Moments moments = moments_of(spheres);
  const Eigen::Vector3d centre = moments.first / moments.volume;
  const Eigen::Matrix3d spread = moments.second - moments.volume * centre * centre.transpose();
  const Eigen::Matrix3d tensor = density * (spread.trace() * Eigen::Matrix3d::Identity() - spread);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;

  GrainShape shape;
  shape.mass = density * moments.volume;
  shape.solid_volume = moments.volume;
  shape.inertia = principal.eigenvalues();
  shape.sphere_radius = spheres.front().radius;
  bool equal = true;
  for (const ClumpSphere& sphere : spheres) {
    shape.sphere_offsets.push_back(axes.transpose() * (sphere.centre - centre));
    shape.sphere_radii.push_back(sphere.radius);
    equal = equal && sphere.radius == spheres.front().radius;
    shape.sphere_radius = std::min(shape.sphere_radius, sphere.radius);
  }
  if (equal) shape.sphere_radii.clear();
  return shape;
}

}  // namespace diefill::engine
