#include "process/measure/volumes/partial_volumes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <random>

#include "process/measure/volumes/sphere_overlap.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

constexpr double kPi = std::numbers::pi;
using Edges = std::array<std::vector<double>, 3>;

double sum_of(const results::CellField& field) {
  return std::accumulate(field.value.begin(), field.value.end(), 0.0);
}

/// Volume beyond three planes by slices: an independent, slow way.
double sliced_ball_beyond(double a, double b, double c) {
  constexpr int kSlices = 4000;
  double volume = 0;
  for (int n = 0; n < kSlices; ++n)
    for (int m = 0; m < kSlices; ++m) {
      const double x = a + (1 - a) * (n + 0.5) / kSlices, y = b + (1 - b) * (m + 0.5) / kSlices;
      const double square = 1 - x * x - y * y;
      if (square <= 0) continue;
      const double top = std::sqrt(square);
      volume += std::max(0.0, top - std::max(-top, c));
    }
  return volume * (1 - a) * (1 - b) / kSlices / kSlices;
}

TEST(SphereOverlap, OctantsHalvesAndCapsOfTheBall) {
  EXPECT_NEAR(ball_beyond(0, 0, 0), kPi / 6, 1e-15);
  EXPECT_NEAR(ball_beyond(-1, 0, 0), kPi / 3, 1e-15);
  EXPECT_NEAR(ball_beyond(-2, -1, 0), 2 * kPi / 3, 1e-15);
  EXPECT_NEAR(ball_beyond(0.5, -1, -1), kPi * 0.25 * 2.5 / 3, 1e-15);
  EXPECT_EQ(ball_beyond(0.6, 0.6, 0.6), 0);
  EXPECT_EQ(ball_beyond(1, -1, -1), 0);
}

TEST(SphereOverlap, ThreePlanesAgreeWithSlices) {
  for (const auto& [a, b, c] : {std::array{0.1, 0.2, 0.3}, std::array{-0.4, 0.5, 0.2},
                                std::array{-0.3, -0.6, 0.1}, std::array{-0.7, -0.2, -0.5}})
    EXPECT_NEAR(ball_beyond(a, b, c), sliced_ball_beyond(a, b, c), 2e-6) << a << ' ' << b << ' ' << c;
}

TEST(SphereOverlap, EightCornersOfAPointInsideMakeTheBall) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-1.1, 1.1);
  for (int n = 0; n < 2000; ++n) {
    const double a = place(random), b = place(random), c = place(random);
    double sum = 0;
    for (const double x : {a, -a})
      for (const double y : {b, -b})
        for (const double z : {c, -c}) sum += ball_beyond(x, y, z);
    // Turned round, x <= a is x >= -a.
    EXPECT_NEAR(sum, 4 * kPi / 3, 1e-13) << a << ' ' << b << ' ' << c;
  }
}

TEST(SphereOverlap, DiscInSectorKnowsLensesAndWedges) {
  EXPECT_NEAR(disc_in_sector(3, 1, 10, -kPi, kPi), kPi, 1e-14);
  EXPECT_NEAR(disc_in_sector(3, 1, 10, 0, kPi), kPi / 2, 1e-14);
  EXPECT_NEAR(disc_in_sector(0.2, 3, 1, -0.3, 0.5), 0.4, 1e-14);
  EXPECT_NEAR(disc_in_sector(0, 1, 3, 0, 1), 0.5, 1e-14);
  // Two unit circles a unit apart share 2 pi / 3 - sqrt(3) / 2.
  EXPECT_NEAR(disc_in_sector(1, 1, 1, -kPi, kPi), 2 * kPi / 3 - std::sqrt(3) / 2, 1e-14);
  EXPECT_EQ(disc_in_sector(3, 1, 1.9, -kPi, kPi), 0);
  EXPECT_NEAR(disc_in_sector(0.5, 1, 10, -kPi, -0.4) + disc_in_sector(0.5, 1, 10, -0.4, 1) +
                  disc_in_sector(0.5, 1, 10, 1, kPi),
              kPi, 1e-13);
}

/// Solid fraction of one lattice cell of edge 1 at the origin, its spheres cut by all faces.
double lattice_fraction(const std::vector<Eigen::Vector3d>& basis, double radius) {
  std::vector<Eigen::Vector3d> places;
  for (int x = -1; x <= 2; ++x)
    for (int y = -1; y <= 2; ++y)
      for (int z = -1; z <= 2; ++z)
        for (const auto& point : basis) places.push_back(point + Eigen::Vector3d(x, y, z));
  const auto field = cartesian_volumes(powder_of(places, 2 * radius),
                                       {even_edges(0, 1, 1), even_edges(0, 1, 1), even_edges(0, 1, 1)});
  return solid_fraction_of(field).value.front();
}

TEST(PartialVolumes, LatticesHaveTheirKnownFractions) {
  EXPECT_NEAR(lattice_fraction({{0, 0, 0}}, 0.5), kPi / 6, 1e-14);
  EXPECT_NEAR(lattice_fraction({{0.3, 0.1, 0.77}}, 0.5), kPi / 6, 1e-14);
  EXPECT_NEAR(lattice_fraction({{0, 0, 0}, {0.5, 0.5, 0.5}}, std::sqrt(3) / 4), kPi * std::sqrt(3) / 8,
              1e-14);
  EXPECT_NEAR(lattice_fraction({{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, std::sqrt(2) / 4),
              kPi * std::sqrt(2) / 6, 1e-14);
}

TEST(PartialVolumes, FaceCutsASphereIntoItsCaps) {
  const auto powder = powder_of({{0.3e-3, 0, 0}}, 1e-3);
  const auto field = cartesian_volumes(powder, {std::vector<double>{-1e-3, 0.5e-3, 1e-3},
                                                even_edges(-1e-3, 1e-3, 1), even_edges(-1e-3, 1e-3, 1)});
  const double cap = std::pow(0.5e-3, 3) * kPi * 0.6 * 0.6 * 2.4 / 3;
  EXPECT_NEAR(field.value[1] / cap, 1, 1e-12);
  EXPECT_NEAR(field.value[0] / (powder.grain_solid_volume - cap), 1, 1e-12);
}

TEST(PartialVolumes, WhatLiesOutsideTheGridIsNotCounted) {
  const auto powder = powder_of({{0, 0, 0}, {5, 5, 5}}, 1);
  const auto field =
      cartesian_volumes(powder, {even_edges(0, 1, 3), even_edges(-1, 1, 2), even_edges(-1, 1, 5)});
  EXPECT_NEAR(sum_of(field), powder.grain_solid_volume / 2, 1e-14);
}

/// Seven touching spheres per grain, turned at random, anywhere in a ring.
results::PowderState clumps(int count, double inner, double outer, double depth) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 1), turn(-1, 1);
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * kPi * unit(random), radius = inner + (outer - inner) * unit(random);
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), -depth * unit(random));
  }
  auto powder = powder_of(places, 1.2e-3);
  powder.sphere_radius = 0.2e-3;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      powder.sphere_offsets.push_back(sign * 0.4e-3 * Eigen::Vector3d::Unit(axis));
  powder.grain_solid_volume = 7 * 4 * kPi / 3 * std::pow(powder.sphere_radius, 3);
  powder.grain_mass = 7000 * powder.grain_solid_volume;
  for (auto& orientation : powder.orientation)
    orientation = Eigen::Vector4d(turn(random), turn(random), turn(random), turn(random)).normalized();
  return powder;
}

results::CavityState ring_cavity() {
  results::CavityState cavity;
  cavity.is_ring = true;
  cavity.inner_radius = 8e-3;
  cavity.outer_radius = 12e-3;
  cavity.lower_corner = {-12e-3, -12e-3, -20e-3};
  cavity.upper_corner = {12e-3, 12e-3, 0};
  cavity.azimuth_zero = {0, -1, 0};
  return cavity;
}

TEST(PartialVolumes, RingPackedWithAKnownMassKeepsIt) {
  const auto powder = clumps(400, 9e-3, 11e-3, 18e-3);
  const double mass = 400 * powder.grain_mass;
  const auto round = cylindrical_volumes(
      powder, ring_cavity(), {even_edges(8e-3, 12e-3, 9), even_edges(0, 360, 90), even_edges(0, 22e-3, 33)});
  EXPECT_NEAR(7000 * sum_of(round) / mass, 1, 1e-9);
  const auto straight = cartesian_volumes(
      powder, {even_edges(-13e-3, 13e-3, 37), even_edges(-13e-3, 13e-3, 41), even_edges(-20e-3, 2e-3, 29)});
  EXPECT_NEAR(7000 * sum_of(straight) / mass, 1, 1e-9);
}

TEST(PartialVolumes, SumsHoldForSpheresOverTheAxisAndCellsSmallerThanTheSpheres) {
  auto cavity = ring_cavity();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-1e-3, 1e-3);
  std::vector<Eigen::Vector3d> places = {{0, 0, -5e-3}};
  for (int k = 0; k < 30; ++k) places.emplace_back(place(random), place(random), -5e-3 + place(random));
  const auto powder = powder_of(places, 1.5e-3);
  const auto field = cylindrical_volumes(
      powder, cavity, {even_edges(0, 4e-3, 11), even_edges(-30, 330, 14), even_edges(10e-3, 20e-3, 23)});
  EXPECT_NEAR(sum_of(field) / (31 * powder.grain_solid_volume), 1, 1e-9);
}

TEST(PartialVolumes, CylinderThroughASphereOnTheAxisTakesTheKnownPart) {
  const auto powder = powder_of({{0, 0, -10e-3}}, 2e-3);
  const auto field = cylindrical_volumes(
      powder, ring_cavity(),
      {std::vector<double>{0, 0.6e-3, 3e-3}, even_edges(0, 360, 3), even_edges(5e-3, 15e-3, 1)});
  const double inside = 4 * kPi / 3 * (1e-9 - std::pow(1e-6 - 0.36e-6, 1.5));
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_NEAR(field.value[field.cell(0, j, 0)] / (inside / 3), 1, 1e-9) << j;
}

/// Part of a sphere between radii, azimuths and heights, by many slices along the radius.
double sliced_round_cell(double distance, double sphere, double r1, double r2, double angle1, double angle2,
                         double z1, double z2) {
  constexpr int kSlices = 3000;
  double volume = 0;
  for (int n = 0; n < kSlices; ++n)
    for (int m = 0; m < kSlices; ++m) {
      const double r = r1 + (r2 - r1) * (n + 0.5) / kSlices,
                   angle = angle1 + (angle2 - angle1) * (m + 0.5) / kSlices;
      const double square =
          sphere * sphere - std::pow(r * std::cos(angle) - distance, 2) - std::pow(r * std::sin(angle), 2);
      if (square <= 0) continue;
      const double top = std::sqrt(square);
      volume += r * std::max(0.0, std::min(top, z2) - std::max(-top, z1));
    }
  return volume * (r2 - r1) * (angle2 - angle1) / kSlices / kSlices;
}

TEST(PartialVolumes, CylindricalCellsAgreeWithSlices) {
  const double degree = kPi / 180;
  const auto powder = powder_of({{0, -10.1, -10}}, 2);  // at azimuth 0 of the cavity
  auto cavity = ring_cavity();
  cavity.lower_corner.z() = -20;
  const auto field =
      cylindrical_volumes(powder, cavity,
                          {std::vector<double>{8, 9.7, 10.6, 12}, std::vector<double>{-20, -2, 1, 20},
                           std::vector<double>{8, 9.6, 10.3, 12}});
  EXPECT_NEAR(sum_of(field) / powder.grain_solid_volume, 1, 1e-12);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(field.value[field.cell(i, 1, k)],
                  sliced_round_cell(10.1, 1, field.edges[0][i], field.edges[0][i + 1], -2 * degree, degree,
                                    field.edges[2][k] - 10, field.edges[2][k + 1] - 10),
                  1e-6)
          << i << ' ' << k;
}

TEST(PartialVolumes, WedgesWithoutCylindersAgreeWithIntegration) {
  const auto powder = powder_of({{10e-3, 0.2e-3, -10e-3}}, 1e-3);
  const std::vector<double> azimuths = even_edges(0, 360, 180), heights = even_edges(0, 20e-3, 61);
  const auto exact =
      cylindrical_volumes(powder, ring_cavity(), {std::vector<double>{8e-3, 12e-3}, azimuths, heights});
  const auto split = cylindrical_volumes(powder, ring_cavity(),
                                         {std::vector<double>{8e-3, 10.05e-3, 12e-3}, azimuths, heights});
  for (std::size_t n = 0; n < exact.value.size(); ++n)
    EXPECT_NEAR(split.value[2 * n] + split.value[2 * n + 1], exact.value[n],
                1e-9 * powder.grain_solid_volume);
}

TEST(PartialVolumes, MapOfARingMeansItsFillDensity) {
  const auto powder = clumps(500, 9e-3, 11e-3, 18e-3);
  const auto cavity = ring_cavity();
  const auto map = partial_volume_map(powder, cavity, 60, 30);
  double mean = 0;
  for (const double value : map.value)
    mean += std::isnan(value) ? 0 : value / static_cast<double>(map.value.size());
  const double ring = kPi * (12e-3 * 12e-3 - 8e-3 * 8e-3) * 20e-3;
  const auto inside = cylindrical_volumes(
      powder, cavity, {std::vector<double>{8e-3, 12e-3}, even_edges(0, 360, 1), even_edges(0, 20e-3, 1)});
  EXPECT_NEAR(mean, inside.value.front() / ring, 1e-12);
  EXPECT_EQ(map.first.size() * map.second.size(), map.value.size());
}

TEST(PartialVolumes, EdgesThatDoNotRiseAreRefused) {
  const auto powder = powder_of({{0, 0, 0}});
  EXPECT_THROW(
      cartesian_volumes(powder, {std::vector<double>{0, 0}, even_edges(0, 1, 1), even_edges(0, 1, 1)}),
      std::invalid_argument);
  EXPECT_THROW(cylindrical_volumes(powder, ring_cavity(),
                                   {even_edges(0, 1, 1), even_edges(0, 400, 4), even_edges(0, 1, 1)}),
               std::invalid_argument);
  results::CavityState box;
  EXPECT_THROW(partial_volume_map(powder, box, 4, 4), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process
