// Cells between spheres of unequal radii: the volume of a closed box, brute-force sampling of the definition,
// and the ordinary cells where radii are equal.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/geometry/voronoi_sample.h"

namespace diefill::geometry {
namespace {

/// Spheres of several radii in a closed box, none of which reaches into another.
VoronoiRequest unequal_spheres(unsigned seed) {
  VoronoiRequest request;
  const Eigen::Vector3d half(10 * kGrainRadius, 8 * kGrainRadius, 9 * kGrainRadius);
  for (const auto& point : random_points(4000, half, seed)) {
    const double radius = kGrainRadius * (request.sphere_centres.size() < 8        ? 3
                                          : request.sphere_centres.size() % 3 == 0 ? 1
                                                                                   : 0.4);
    bool free = true;
    for (std::size_t k = 0; k < request.sphere_centres.size() && free; ++k)
      free = (request.sphere_centres[k] - point).norm() > radius + request.sphere_radii[k];
    if (!free || request.sphere_centres.size() >= 300) continue;
    request.sphere_centres.push_back(point);
    request.sphere_radii.push_back(radius);
  }
  request.largest_reach = 60 * kGrainRadius;
  add_box_walls(request, half + Eigen::Vector3d::Constant(3 * kGrainRadius), 1e6 * kGrainRadius);
  return request;
}

TEST(RadicalCells, OfUnequalSpheresFillTheBoxAndHoldTheirSpheres) {
  const VoronoiRequest request = unequal_spheres(4);
  const VoronoiCells cells = voronoi_cells(request);
  ASSERT_GT(cells.volume.size(), 200U);
  const double box = 8 * 13 * 11 * 12 * std::pow(kGrainRadius, 3);
  EXPECT_NEAR(total(cells), box, 1e-4 * box);
  for (std::size_t k = 0; k < cells.volume.size(); ++k) {
    EXPECT_EQ(cells.open[k], 0);
    EXPECT_GT(cells.volume[k], sphere_volume(request.sphere_radii[k]) * (1 - 1e-9)) << k;
  }
}

TEST(RadicalCells, HoldThePointsOfSmallestPower) {
  // A point belongs to the sphere of smallest distance^2 - radius^2.
  const VoronoiRequest request = unequal_spheres(5);
  const VoronoiCells cells = voronoi_cells(request);
  const Eigen::Vector3d half(13 * kGrainRadius, 11 * kGrainRadius, 12 * kGrainRadius);
  constexpr int kPoints = 200000;
  std::vector<double> found(cells.volume.size(), 0);
  for (const auto& point : random_points(kPoints, half, 17)) {
    std::size_t owner = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double power = (point - request.sphere_centres[k]).squaredNorm() -
                           request.sphere_radii[k] * request.sphere_radii[k];
      if (power < least) owner = k;
      least = std::min(least, power);
    }
    found[owner] += 8 * half.prod() / kPoints;
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double scatter = std::sqrt(cells.volume[k] * 8 * half.prod() / kPoints);
    EXPECT_NEAR(found[k], cells.volume[k], 5 * scatter) << k;
  }
}

TEST(RadicalCells, OfEqualRadiiAreTheOrdinaryOnesBitForBit) {
  VoronoiRequest request = lattice_between_walls(4, 5, 2 * kGrainRadius);
  for (auto& centre : request.sphere_centres)
    centre.x() += 0.1 * kGrainRadius * std::sin(centre.z() / kGrainRadius);
  const VoronoiCells ordinary = voronoi_cells(request);
  request.sphere_radii.assign(request.sphere_centres.size(), request.sphere_radius);
  EXPECT_EQ(voronoi_cells(request).volume, ordinary.volume);
}

TEST(RadicalCells, PlaneBetweenTwoIsWhereTangentsToBothAreEquallyLong) {
  const double large = 2 * kGrainRadius, small = kGrainRadius, distance = 3.2 * kGrainRadius;
  VoronoiRequest request;
  request.sphere_centres = {{-0.5 * distance, 0, 0}, {0.5 * distance, 0, 0}};
  request.sphere_radii = {large, small};
  request.largest_reach = 30 * kGrainRadius;
  add_box_walls(request, {distance, large, large}, 1e6 * kGrainRadius);
  const VoronoiCells cells = voronoi_cells(request);
  const double to_plane = (distance * distance + large * large - small * small) / (2 * distance);
  const double area = 4 * large * large;
  EXPECT_NEAR(cells.volume[0], (0.5 * distance + to_plane) * area, 1e-4 * area * kGrainRadius);
  EXPECT_NEAR(cells.volume[1], (1.5 * distance - to_plane) * area, 1e-4 * area * kGrainRadius);
}

TEST(RadicalCells, OfAPeriodicLatticeByTurnsLargeAndSmallShareTheSpaceOfTwoSites) {
  constexpr int kColumns = 4;
  VoronoiRequest request = lattice_between_walls(kColumns, 5, 2 * kGrainRadius);
  for (std::size_t n = 0; n < request.sphere_centres.size(); ++n) {
    const std::size_t x = n % kColumns, y = n / kColumns % kColumns, z = n / (kColumns * kColumns);
    request.sphere_radii.push_back((x + y + z) % 2 == 0 ? 0.95 * kGrainRadius : 0.6 * kGrainRadius);
  }
  const VoronoiCells cells = voronoi_cells(request);
  const double site = 8 * std::pow(kGrainRadius, 3);
  const std::size_t middle = 2 * kColumns * kColumns;  // first of the layer farthest from the walls
  EXPECT_NEAR(cells.volume[middle] + cells.volume[middle + 1], 2 * site, 1e-9 * site);
  EXPECT_GT(cells.volume[middle], 1.2 * site);
  // At the period's border the same as inside.
  EXPECT_NEAR(cells.volume[middle + 2], cells.volume[middle], 1e-9 * site);
}

TEST(RadicalCells, RefuseRadiiThatDoNotMatch) {
  VoronoiRequest request = lattice_between_walls(2, 2, 2 * kGrainRadius);
  request.sphere_radii = {kGrainRadius};
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
  request.sphere_radii.assign(request.sphere_centres.size(), 0.0);
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::geometry
