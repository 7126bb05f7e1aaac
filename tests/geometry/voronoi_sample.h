// Points to be divided up: lattices between walls, closed boxes, random points.
#pragma once

#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "geometry/voronoi/voronoi.h"

namespace diefill::geometry {

inline constexpr double kGrainRadius = 7.84e-5;  // m, a size powder really has

inline double sphere_volume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// `columns` x `columns` x `layers` points of a simple cubic lattice; the first layer half a constant above z
/// = 0.
inline std::vector<Eigen::Vector3d> cubic_lattice(int columns, int layers, double constant) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < columns; ++i)
        points.push_back(constant *
                         Eigen::Vector3d(i + 0.5 - 0.5 * columns, j + 0.5 - 0.5 * columns, k + 0.5));
  return points;
}

/// A wall sphere straight below (or above) every site of the lattice's outermost layer, its surface touching
/// `height`.
inline void add_wall(VoronoiRequest& request, int columns, double constant, double height, bool below,
                     double radius) {
  for (const auto& site : cubic_lattice(columns, 1, constant)) {
    request.wall_centres.emplace_back(site.x(), site.y(), below ? height - radius : height + radius);
    request.wall_radii.push_back(radius);
  }
}

/// A lattice between two walls, periodic along x and y.
inline VoronoiRequest lattice_between_walls(int columns, int layers, double constant) {
  VoronoiRequest request;
  request.sphere_centres = cubic_lattice(columns, layers, constant);
  request.sphere_radius = 0.5 * constant;
  request.period = {columns * constant, columns * constant};
  request.largest_reach = 3 * constant;
  add_wall(request, columns, constant, 0, true, 0.4 * constant);
  add_wall(request, columns, constant, layers * constant, false, 0.4 * constant);
  return request;
}

/// Six spheres so large that their surfaces are the flat faces of a box with half edges `half`.
inline void add_box_walls(VoronoiRequest& request, const Eigen::Vector3d& half, double wall_radius) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      centre[axis] = side * (half[axis] + wall_radius);
      request.wall_centres.push_back(centre);
      request.wall_radii.push_back(wall_radius);
    }
  }
}

inline std::vector<Eigen::Vector3d> random_points(int number, const Eigen::Vector3d& half, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Vector3d> points(number);
  for (auto& point : points)
    for (int axis = 0; axis < 3; ++axis) point[axis] = half[axis] * uniform(generator);
  return points;
}

inline double total(const VoronoiCells& cells) {
  return std::accumulate(cells.volume.begin(), cells.volume.end(), 0.0);
}

}  // namespace diefill::geometry
