// Voronoi cells against lattices with known cells, against the volume of a closed box and against brute-force
// sampling of the definition.
#include "geometry/voronoi/voronoi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/geometry/voronoi_sample.h"

namespace diefill::geometry {
namespace {

TEST(VoronoiCells, SimpleCubicLatticeFillsPiOverSixBetweenWalls) {
  const VoronoiRequest request = lattice_between_walls(4, 5, 2 * kGrainRadius);
  const VoronoiCells cells = voronoi_cells(request);
  ASSERT_EQ(cells.volume.size(), request.sphere_centres.size());
  for (std::size_t k = 0; k < cells.volume.size(); ++k) {
    EXPECT_EQ(cells.open[k], 0);
    EXPECT_NEAR(sphere_volume(kGrainRadius) / cells.volume[k], std::numbers::pi / 6, 1e-12);
  }
}

TEST(VoronoiCells, BodyCentredLatticeHasTwoEqualCellsACube) {
  const double constant = 4 * kGrainRadius / std::sqrt(3.0);
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.period = {3 * constant, 3 * constant};
  request.largest_reach = 3 * constant;
  for (const auto& corner : cubic_lattice(3, 6, constant)) {
    request.sphere_centres.push_back(corner);
    request.sphere_centres.push_back(corner + Eigen::Vector3d::Constant(0.5 * constant));
  }
  const VoronoiCells cells = voronoi_cells(request);
  int inside = 0;
  for (std::size_t k = 0; k < cells.volume.size(); ++k) {
    const double z = request.sphere_centres[k].z();
    if (z < 1.2 * constant || z > 4.8 * constant) continue;
    ++inside;
    EXPECT_EQ(cells.open[k], 0);
    EXPECT_NEAR(cells.volume[k] / std::pow(constant, 3), 0.5, 1e-12);
    EXPECT_NEAR(sphere_volume(kGrainRadius) / cells.volume[k], std::numbers::pi * std::sqrt(3.0) / 8, 1e-12);
  }
  EXPECT_GE(inside, 50);
}

TEST(VoronoiCells, PeriodMayBeShorterThanReach) {
  VoronoiRequest request = lattice_between_walls(1, 3, 2 * kGrainRadius);
  const VoronoiCells cells = voronoi_cells(request);
  for (std::size_t k = 0; k < cells.volume.size(); ++k) {
    EXPECT_EQ(cells.open[k], 0);
    EXPECT_NEAR(cells.volume[k] / std::pow(2 * kGrainRadius, 3), 1.0, 1e-12);
  }
}

TEST(VoronoiCells, SpheresOutsideThePeriodicBoxCountAtTheirImage) {
  VoronoiRequest request = lattice_between_walls(4, 3, 2 * kGrainRadius);
  const VoronoiCells plain = voronoi_cells(request);
  for (std::size_t k = 0; k < request.sphere_centres.size(); k += 3)
    request.sphere_centres[k].x() += 2 * *request.period[0];
  const VoronoiCells shifted = voronoi_cells(request);
  for (std::size_t k = 0; k < plain.volume.size(); ++k)
    EXPECT_NEAR(shifted.volume[k] / plain.volume[k], 1.0, 1e-9);
}

TEST(VoronoiCells, CellsFillAPeriodicBoxBetweenWalls) {
  const int columns = 6, layers = 8;
  const double constant = 2.3 * kGrainRadius;
  VoronoiRequest request = lattice_between_walls(columns, layers, constant);
  request.sphere_radius = kGrainRadius;
  // The outermost layers stay in place, where each stands squarely on its wall sphere; the rest is
  // disordered.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shift(-0.2 * constant, 0.2 * constant);
  for (auto& centre : request.sphere_centres)
    if (centre.z() > constant && centre.z() < (layers - 1) * constant)
      centre += Eigen::Vector3d(shift(generator), shift(generator), shift(generator));
  const VoronoiCells cells = voronoi_cells(request);
  EXPECT_EQ(std::accumulate(cells.open.begin(), cells.open.end(), 0), 0);
  EXPECT_NEAR(total(cells) / (columns * columns * layers * std::pow(constant, 3)), 1.0, 1e-9);
}

TEST(VoronoiCells, CellsOfRandomGrainsFillABoxWithFlatWalls) {
  const Eigen::Vector3d half(8 * kGrainRadius, 9 * kGrainRadius, 10 * kGrainRadius);
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = random_points(240, half, 11);
  request.spheres_per_grain = 3;  // what belongs together has no say in how space is divided
  request.largest_reach = 60 * kGrainRadius;
  add_box_walls(request, half, 1e7 * kGrainRadius);
  const VoronoiCells cells = voronoi_cells(request);
  EXPECT_EQ(cells.volume.size(), 80u);
  EXPECT_EQ(std::accumulate(cells.open.begin(), cells.open.end(), 0), 0);
  EXPECT_NEAR(total(cells) / (8 * half.prod()), 1.0, 1e-5);
}

TEST(VoronoiCells, GrainsCellIsTheUnionOfItsSpheresCells) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(8 * kGrainRadius);
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = random_points(120, half, 5);
  request.largest_reach = 60 * kGrainRadius;
  add_box_walls(request, half, 1e6 * kGrainRadius);
  const VoronoiCells spheres = voronoi_cells(request);
  request.spheres_per_grain = 4;
  const VoronoiCells grains = voronoi_cells(request);
  for (std::size_t k = 0; k < grains.volume.size(); ++k) {
    const double sum =
        std::accumulate(spheres.volume.begin() + 4 * k, spheres.volume.begin() + 4 * k + 4, 0.0);
    EXPECT_DOUBLE_EQ(grains.volume[k], sum);
  }
}

/// Crosses of seven spheres (model D) on a lattice so wide that each grain's cell is a cube.
VoronoiRequest crosses(double constant, const std::vector<Eigen::Vector3d>& cross) {
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.spheres_per_grain = cross.size();
  request.period = {3 * constant, 3 * constant};
  request.largest_reach = 2 * constant;
  for (const auto& site : cubic_lattice(3, 3, constant))
    for (const auto& offset : cross) request.sphere_centres.push_back(site + offset);
  add_wall(request, 3, constant, 0, true, kGrainRadius);
  add_wall(request, 3, constant, 3 * constant, false, kGrainRadius);
  return request;
}

std::vector<Eigen::Vector3d> model_d_cross() {
  std::vector<Eigen::Vector3d> cross = {Eigen::Vector3d::Zero()};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-2.0, 2.0}) cross.push_back(side * kGrainRadius * Eigen::Vector3d::Unit(axis));
  return cross;
}

TEST(VoronoiCells, InnerSpheresOfClosedGrainsAreNoReasonForAnOpenCell) {
  const double constant = 6.5 * kGrainRadius;
  const VoronoiCells cells = voronoi_cells(crosses(constant, model_d_cross()));
  ASSERT_EQ(cells.volume.size(), 27u);
  for (std::size_t k = 9; k < 18; ++k) {  // the middle layer meets no wall
    EXPECT_EQ(cells.open[k], 0);
    EXPECT_NEAR(cells.volume[k] / std::pow(constant, 3), 1.0, 1e-10);
  }
}

TEST(VoronoiCells, SphereRepeatedWithinAGrainCountsOnce) {
  const double constant = 6.5 * kGrainRadius;
  auto doubled = model_d_cross();
  doubled.push_back(doubled.front());
  const VoronoiCells once = voronoi_cells(crosses(constant, model_d_cross()));
  const VoronoiCells twice = voronoi_cells(crosses(constant, doubled));
  for (std::size_t k = 0; k < once.volume.size(); ++k) {
    EXPECT_NEAR(twice.volume[k] / once.volume[k], 1.0, 1e-12);
    EXPECT_EQ(twice.open[k], once.open[k]);
  }
}

TEST(VoronoiCells, GrainsOnTheVerySamePlaceHaveNoCell) {
  VoronoiRequest request = lattice_between_walls(3, 3, 2 * kGrainRadius);
  request.sphere_centres.push_back(request.sphere_centres[13]);
  const VoronoiCells cells = voronoi_cells(request);
  for (std::size_t k = 0; k < cells.open.size(); ++k)
    EXPECT_EQ(cells.open[k], k == 13 || k == 27 ? 1 : 0) << k;
}

TEST(VoronoiCells, FreeSurfaceIsOpenAndTheRestIsNot) {
  VoronoiRequest request = lattice_between_walls(4, 5, 2 * kGrainRadius);
  request.wall_centres.resize(16);  // the floor alone
  request.wall_radii.resize(16);
  const VoronoiCells cells = voronoi_cells(request);
  for (std::size_t k = 0; k < cells.open.size(); ++k) EXPECT_EQ(cells.open[k], k >= 64 ? 1 : 0) << k;
}

TEST(VoronoiCells, LoneSphereKeepsWithinTheReach) {
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = {Eigen::Vector3d(1e-3, -2e-3, 5e-3)};
  request.largest_reach = 9 * kGrainRadius;
  const VoronoiCells cells = voronoi_cells(request);
  EXPECT_EQ(cells.open[0], 1);
  EXPECT_LT(cells.volume[0], sphere_volume(request.largest_reach));
  EXPECT_GT(cells.volume[0], 0.7 * sphere_volume(request.largest_reach));
}

TEST(VoronoiCells, WallSphereCutsOnItsOwnSurface) {
  // One sphere in a box of flat walls, above a small wall sphere: the floor moves up to that sphere's top.
  const double half = 5 * kGrainRadius, wall_radius = 1.91 * kGrainRadius, top = -2 * kGrainRadius;
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = {Eigen::Vector3d(0, 0, 0.5 * kGrainRadius)};
  request.largest_reach = 40 * kGrainRadius;
  add_box_walls(request, Eigen::Vector3d::Constant(half), 1e8 * kGrainRadius);
  request.wall_centres.emplace_back(0, 0, top - wall_radius);
  request.wall_radii.push_back(wall_radius);
  const VoronoiCells cells = voronoi_cells(request);
  EXPECT_EQ(cells.open[0], 0);
  EXPECT_NEAR(cells.volume[0] / (4 * half * half * (half - top)), 1.0, 1e-6);
}

TEST(VoronoiCells, WallCutsASphereThatItOverlaps) {
  const double half = 5 * kGrainRadius, wall_radius = 2 * kGrainRadius;
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = {
      Eigen::Vector3d(0, 0, -0.1 * kGrainRadius)};  // its centre lies within the wall sphere
  request.largest_reach = 40 * kGrainRadius;
  add_box_walls(request, Eigen::Vector3d::Constant(half), 1e8 * kGrainRadius);
  request.wall_centres.emplace_back(0, 0, -wall_radius);
  request.wall_radii.push_back(wall_radius);
  const VoronoiCells cells = voronoi_cells(request);
  EXPECT_EQ(cells.open[0], 0);
  EXPECT_NEAR(cells.volume[0] / (4 * half * half * half), 1.0, 1e-6);
}

/// The definition, point by point: the sphere whose cell holds `point`, or none where a wall plane cuts it
/// off.
int owner_by_definition(const VoronoiRequest& request, const Eigen::Vector3d& point) {
  int owner = -1;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < request.sphere_centres.size(); ++i) {
    const double distance = (request.sphere_centres[i] - point).norm();
    if (distance < nearest) nearest = distance, owner = static_cast<int>(i);
  }
  for (std::size_t w = 0; w < request.wall_centres.size(); ++w) {
    const Eigen::Vector3d e = (request.sphere_centres[owner] - request.wall_centres[w]).normalized();
    if ((point - request.wall_centres[w]).dot(e) < request.wall_radii[w]) return -1;
  }
  return owner;
}

TEST(VoronoiCells, AgreeWithSamplingOfTheDefinitionOverARoughFloor) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(4 * kGrainRadius);
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = random_points(24, half, 17);
  request.largest_reach = 60 * kGrainRadius;
  add_box_walls(request, half, 1e6 * kGrainRadius);
  for (const auto& site : cubic_lattice(5, 1, 1.6 * kGrainRadius)) {
    request.wall_centres.emplace_back(site.x(), site.y(), -half.z() - 0.6 * kGrainRadius);
    request.wall_radii.push_back(kGrainRadius);
  }
  const VoronoiCells cells = voronoi_cells(request);
  const int samples = 60;
  std::vector<double> sampled(request.sphere_centres.size());
  const double share = 8 * half.prod() / std::pow(samples, 3);
  for (int n = 0; n < samples * samples * samples; ++n) {
    const Eigen::Array3d node(n % samples, n / samples % samples, n / samples / samples);
    const Eigen::Vector3d point = half.array() * (2 * (node + 0.5) / samples - 1);
    const int owner = owner_by_definition(request, point);
    if (owner >= 0) sampled[owner] += share;
  }
  for (std::size_t i = 0; i < sampled.size(); ++i)
    EXPECT_NEAR(cells.volume[i], sampled[i], 0.01 * 8 * half.prod() / 24 + 0.02 * sampled[i]) << i;
}

TEST(VoronoiCells, AreTheSameBitForBitWhenRepeated) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(14 * kGrainRadius);
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.sphere_centres = random_points(2100, half, 23);
  request.spheres_per_grain = 7;
  request.largest_reach = 12 * kGrainRadius;
  const VoronoiCells first = voronoi_cells(request), second = voronoi_cells(request);
  EXPECT_EQ(first.volume, second.volume);
  EXPECT_EQ(first.open, second.open);
}

TEST(VoronoiCells, RefuseRequestsThatMakeNoSense) {
  VoronoiRequest request = lattice_between_walls(2, 2, kGrainRadius);
  request.spheres_per_grain = 3;
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
  request = lattice_between_walls(2, 2, kGrainRadius);
  request.wall_radii.pop_back();
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
  request = lattice_between_walls(2, 2, kGrainRadius);
  request.largest_reach = 0;
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
  request = lattice_between_walls(2, 2, kGrainRadius);
  request.period[0] = 0;
  EXPECT_THROW(voronoi_cells(request), std::invalid_argument);
}

TEST(VoronoiCells, OfNothingAreNone) {
  VoronoiRequest request;
  request.sphere_radius = kGrainRadius;
  request.largest_reach = kGrainRadius;
  EXPECT_TRUE(voronoi_cells(request).volume.empty());
}

}  // namespace
}  // namespace diefill::geometry
