// Solid fractions, statistics, masses and levels of powders that can be worked out by hand.
#include <gtest/gtest.h>

#include <numeric>

#include "process/measure/cavity_position.h"
#include "process/measure/measure.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

/// A column of a cubic lattice, periodic over `columns` constants, standing on a floor with one wall sphere
/// below each site.
struct Bed {
  results::PowderState powder;
  std::vector<results::ToolState> tools;
};

Bed lattice_bed(int columns, int layers, double constant) {
  Bed bed;
  std::vector<Eigen::Vector3d> places;
  results::ToolState floor;
  floor.wall_sphere_radius = 0.4 * constant;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < columns; ++i) {
        places.push_back(constant *
                         Eigen::Vector3d(i - 0.5 * (columns - 1), j - 0.5 * (columns - 1), k + 0.5));
        if (k == 0)
          floor.wall_sphere_centres.emplace_back(places.back().x(), places.back().y(),
                                                 -floor.wall_sphere_radius);
      }
  bed.powder = powder_of(places, constant);
  bed.tools = {floor};
  bed.powder.period = {columns * constant, columns * constant};
  return bed;
}

TEST(SolidFraction, OfALatticeIsPiOverSixAndItsSurfaceIsOpen) {
  const Bed bed = lattice_bed(5, 8, kDiameter);
  const auto fraction = measure_solid_fraction(bed.powder, bed.tools, {});
  for (std::size_t k = 0; k < 200; ++k) {
    EXPECT_EQ(fraction.open[k], k >= 175 ? 1 : 0);
    if (k < 175) {
      EXPECT_NEAR(fraction.solid_fraction[k], std::numbers::pi / 6, 1e-12);
    }
    EXPECT_EQ(fraction.in_cavity[k], 0);  // there is no cavity
  }
  EXPECT_NEAR(bulk_solid_fraction(bed.powder, fraction), std::numbers::pi / 6, 1e-12);
}

TEST(SolidFraction, OfNoPowderIsEmpty) {
  EXPECT_TRUE(measure_solid_fraction(powder_of({}), {}, {}).solid_fraction.empty());
  EXPECT_TRUE(std::isnan(bulk_solid_fraction(powder_of({}), {})));
}

TEST(SolidFraction, OfARingInsideALattice) {
  const results::CavityState ring = sample_ring();
  // The lattice goes on beyond the ring, so that no cell of the ring is at an edge.
  results::CavityState wider = ring;
  wider.inner_radius -= 3e-3;
  wider.outer_radius += 3e-3;
  const results::PowderState powder =
      powder_of(lattice_in_ring(wider, kDiameter, [](double) { return 6e-3; }));
  const auto fraction = measure_solid_fraction(powder, {}, ring);
  std::uint64_t deep = 0, at_two_diameters = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const RingPosition place = ring_position(ring, powder.position[k]);
    const bool inside = place.radius >= ring.inner_radius && place.radius <= ring.outer_radius;
    ASSERT_EQ(fraction.in_cavity[k], inside ? 1 : 0);
    if (!inside || place.height < kDiameter || place.height > 5e-3) continue;
    ++(place.height < 4.5e-3 ? deep : at_two_diameters);
    EXPECT_EQ(fraction.open[k], 0);
    EXPECT_NEAR(fraction.solid_fraction[k], std::numbers::pi / 6, 1e-12);
  }
  const auto summary = summarise(powder, fraction, ring);
  EXPECT_NEAR(summary.mean, std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(summary.std, 0, 1e-12);
  // Layers at 0.25, 0.75, ... 5.75 mm. The lowest is open; that at 4.75 mm is 2 d deep but for rounding.
  EXPECT_GE(summary.grains, deep);
  EXPECT_LE(summary.grains, deep + at_two_diameters);
  const auto map = cylindrical_map(powder, fraction, {}, ring, 5e-4);
  EXPECT_EQ(map.value.size(), 181u * 25u);
  for (std::size_t n = 0; n < map.value.size(); ++n) {
    const double height = map.second[n / map.first.size()];
    if (height > 0.7 && height < 5.3) {
      EXPECT_NEAR(map.value[n], std::numbers::pi / 6, 1e-12);
    }
  }
}

TEST(CavityPosition, TellsBoxesAndRings) {
  results::CavityState ring = sample_ring();
  const auto on_ring = [&](double azimuth, double radius, double height) {
    return lies_in_cavity(ring, ring_point(ring, {azimuth, radius, height}));
  };
  EXPECT_TRUE(on_ring(33, 9e-3, 3e-3));
  EXPECT_FALSE(on_ring(33, 7.9e-3, 3e-3));
  EXPECT_FALSE(on_ring(45, 11.1e-3, 3e-3));  // within the box
  EXPECT_FALSE(on_ring(33, 9e-3, -1e-4));
  EXPECT_FALSE(on_ring(33, 9e-3, 6.1e-3));
  ring.is_ring = false;
  EXPECT_TRUE(on_ring(33, 7.9e-3, 3e-3));
  EXPECT_FALSE(lies_in_cavity({}, Eigen::Vector3d::Zero()));
}

TEST(CavityPosition, TurnsCounterClockwiseFromAzimuthZero) {
  results::CavityState ring = sample_ring();
  ring.azimuth_zero = {0, -1, 0};
  const Eigen::Vector3d centre = ring.axis_origin;
  EXPECT_NEAR(ring_position(ring, centre + Eigen::Vector3d(0, -1, 0)).azimuth, 0, 1e-12);
  EXPECT_NEAR(ring_position(ring, centre + Eigen::Vector3d(1, 0, 0)).azimuth, 90, 1e-12);
  EXPECT_NEAR(ring_position(ring, centre + Eigen::Vector3d(0, 1, 0)).azimuth, 180, 1e-12);
  EXPECT_NEAR(ring_position(ring, centre + Eigen::Vector3d(-1, 0, 0)).azimuth, 270, 1e-12);
  EXPECT_LT(ring_position(ring, centre + Eigen::Vector3d(-1e-20, -1, 0)).azimuth, 360);
  const RingPosition back = ring_position(ring, ring_point(ring, {217, 9e-3, 2e-3}));
  EXPECT_NEAR(back.azimuth, 217, 1e-9);
  EXPECT_NEAR(back.radius, 9e-3, 1e-15);
  EXPECT_NEAR(back.height, 2e-3, 1e-15);
}

TEST(FilledMass, CountsGrainsInTheCavity) {
  const results::PowderState powder = powder_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  results::GrainSolidFraction fraction = fraction_of(powder, [](const auto&) { return 0.5; });
  fraction.in_cavity[1] = 0;
  EXPECT_EQ(filled_mass(powder, fraction), 2 * 7.63e-8);
}

/// A column of eight grains one d apart, so that the lowest six are 2 d or more below the surface.
results::PowderState column(double x, int grains) {
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < grains; ++k) places.emplace_back(x, 0, k * 1.0);
  return powder_of(places, 1.0);  // whole numbers: depths are exact
}

TEST(Summary, MatchesNumbersWorkedOutByHand) {
  const results::PowderState powder = column(0, 8);
  results::GrainSolidFraction fraction = fraction_of(powder, [](const auto&) { return 0.9; });
  const double volume = powder.grain_solid_volume;
  const std::vector<double> values = {0.7, 0.2, 0.4, 0.5, 0.1, 0.25};
  for (std::size_t k = 0; k < values.size(); ++k) {
    fraction.solid_fraction[k] = values[k];
    fraction.cell_volume[k] = volume / values[k];
  }
  fraction.open[0] = 1;       // left out: 0.7
  fraction.in_cavity[4] = 0;  // left out: 0.1; grains 6 and 7 are too near the surface
  const auto summary = summarise(powder, fraction, {});
  EXPECT_EQ(summary.grains, 4u);               // 0.2, 0.4, 0.5, 0.25
  EXPECT_NEAR(summary.mean, 4 / 13.5, 1e-15);  // 4 V / (5 + 2.5 + 2 + 4) V
  EXPECT_NEAR(summary.arithmetic_mean, 0.3375, 1e-15);
  EXPECT_NEAR(summary.std * summary.std, 0.01421875, 1e-15);  // mean of squares 0.128125 less 0.3375^2
  EXPECT_EQ(summary.min, 0.2);
  EXPECT_EQ(summary.max, 0.5);
  EXPECT_NEAR(summary.cv, std::sqrt(0.01421875) / 0.3375, 1e-14);
}

TEST(Summary, TakesTheSurfaceFromTheNeighbourhood) {
  // A low column far from a tall one has its own surface; beside it the tall one's counts.
  results::PowderState far = column(0, 8), low = column(5, 3);
  far.position.insert(far.position.end(), low.position.begin(), low.position.end());
  const auto all = [](const results::PowderState& powder) {
    return fraction_of(powder, [](const auto&) { return 0.5; });
  };
  EXPECT_EQ(summarise(far, all(far), {}).grains, 6u + 1u);
  results::PowderState near = column(0, 8);
  low = column(1, 3);
  near.position.insert(near.position.end(), low.position.begin(), low.position.end());
  EXPECT_EQ(summarise(near, all(near), {}).grains, 6u + 3u);
}

TEST(Summary, TakesTheSurfaceAcrossAPeriodicBoundary) {
  // The tall column lies within d of the low one through the boundary at 3.
  for (const bool along_x : {true, false}) {
    results::PowderState powder = column(-2.5, 8), low = column(2.5, 3);
    if (!along_x)
      for (auto* each : {&powder, &low})
        for (auto& place : each->position) place = {0, place.x(), place.z()};
    powder.position.insert(powder.position.end(), low.position.begin(), low.position.end());
    const auto fraction = fraction_of(powder, [](const auto&) { return 0.5; });
    EXPECT_EQ(summarise(powder, fraction, {}).grains, 6u + 1u);
    powder.period[along_x ? 0 : 1] = 6;
    EXPECT_EQ(summarise(powder, fraction, {}).grains, 6u + 3u);
  }
}

TEST(Summary, OfNothingIsNoNumber) {
  const results::PowderState powder = column(0, 2);
  const auto summary = summarise(powder, fraction_of(powder, [](const auto&) { return 0.5; }), {});
  EXPECT_EQ(summary.grains, 0u);
  for (const double value :
       {summary.mean, summary.arithmetic_mean, summary.std, summary.min, summary.max, summary.cv})
    EXPECT_TRUE(std::isnan(value));
}

TEST(FillLevel, FollowsAStaircase) {
  const results::CavityState ring = sample_ring();
  const auto stair = [](double azimuth) { return (1 + std::floor(azimuth / 40)) * kDiameter; };
  const results::PowderState powder = powder_of(lattice_in_ring(ring, kDiameter, stair));
  const auto level = fill_level(powder, ring, 36);
  ASSERT_EQ(level.x.size(), 36u);
  EXPECT_EQ(level.unit, "mm");
  EXPECT_EQ(level.x[0], 5);
  EXPECT_EQ(level.x[35], 355);
  for (std::size_t bin = 0; bin < 36; ++bin)
    EXPECT_NEAR(level.y[bin], stair(level.x[bin]) * 1e3, 1e-9) << bin;
}

TEST(FillLevel, HasNoValueWhereThereIsNoPowderAndOverlooksPowderBesideTheRing) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder =
      powder_of({ring_point(ring, {15, 9e-3, 1e-3}), ring_point(ring, {15, 12e-3, 5e-3}),
                 ring_point(ring, {95, 7e-3, 5e-3}), ring_point(ring, {185, 9e-3, -2e-3})});
  const auto level = fill_level(powder, ring, 36);
  for (std::size_t bin = 0; bin < 36; ++bin) {
    if (bin == 1)
      EXPECT_NEAR(level.y[bin], 1.25, 1e-9);  // the sphere's top, 0.25 mm above its centre
    else
      EXPECT_TRUE(std::isnan(level.y[bin])) << bin;
  }
  EXPECT_THROW(fill_level(powder, ring, 0), std::invalid_argument);
  EXPECT_THROW(fill_level(powder, {}, 36), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process
