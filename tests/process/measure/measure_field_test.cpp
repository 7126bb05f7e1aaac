// Gaussian fields: constants stay, gradients come back, holes stay holes, tools are cut out.
#include <gtest/gtest.h>

#include "process/measure/fields/gaussian_field.h"
#include "process/measure/measure.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double at(const results::Field2D& field, std::size_t i, std::size_t j) {
  return field.value.at(j * field.first.size() + i);
}

TEST(GaussianField, WeighsTwoGrainsByTheirDistances) {
  const double sigma = 4e-4;
  const results::PowderState powder = powder_of({{0, 0, 0}, {kDiameter, 0, 0}});
  results::GrainSolidFraction fraction =
      fraction_of(powder, [](const auto& place) { return place.x() > 0 ? 0.6 : 0.2; });
  const GaussianField field(powder, fraction, sigma);
  const double x = 1e-4;
  const double first = std::exp(-x * x / (2 * sigma * sigma));
  const double second = std::exp(-(kDiameter - x) * (kDiameter - x) / (2 * sigma * sigma));
  EXPECT_NEAR(field.at({x, 0, 0}), (0.2 * first + 0.6 * second) / (first + second), 1e-14);
  fraction.open[1] = 1;  // an open cell has no say
  EXPECT_DOUBLE_EQ(GaussianField(powder, fraction, sigma).at({x, 0, 0}), 0.2);
}

TEST(GaussianField, ConstantStaysConstantAndEndsWithThePowder) {
  const results::PowderState powder = powder_of(block(8, kDiameter));
  const GaussianField field(powder, fraction_of(powder, [](const auto&) { return 0.35; }), 5e-4);
  const double edge = 3.5 * kDiameter;
  for (const double x : {-1.0, -0.5, 0.0, 0.3, 1.0})
    EXPECT_NEAR(field.at({x * edge, 0.1 * x * edge, 0}), 0.35, 1e-14);
  EXPECT_FALSE(std::isnan(field.at({edge + 7.4e-4, 0.5 * kDiameter, 0.5 * kDiameter})));
  EXPECT_TRUE(std::isnan(field.at({edge + 7.6e-4, 0.5 * kDiameter, 0.5 * kDiameter})));
  EXPECT_TRUE(std::isnan(field.at({1, 1, 1})));
}

TEST(GaussianField, GivesBackALinearFieldInsideALattice) {
  const results::PowderState powder = powder_of(block(16, kDiameter));
  const auto line = [](const Eigen::Vector3d& place) { return 0.4 + 20 * place.x() - 10 * place.z(); };
  const GaussianField field(powder, fraction_of(powder, line), kDiameter);
  for (const double x : {-2.0, -0.3, 0.0, 0.5, 1.7}) {
    const Eigen::Vector3d place = kDiameter * Eigen::Vector3d(x, 0.2 * x, -0.5 * x);
    EXPECT_NEAR(field.at(place), line(place), 2e-5);  // what the cut at 4 sigma and the lattice leave
  }
}

TEST(GaussianField, SeesPeriodicImages) {
  results::PowderState powder = powder_of({{0, 1.9e-3, 0}});
  const results::GrainSolidFraction fraction = fraction_of(powder, [](const auto&) { return 0.5; });
  EXPECT_TRUE(std::isnan(GaussianField(powder, fraction, 3e-4).at({0, -1.9e-3, 0})));
  powder.period = {0, 4e-3};
  EXPECT_DOUBLE_EQ(GaussianField(powder, fraction, 3e-4).at({0, -1.9e-3, 0}), 0.5);
}

TEST(GaussianField, RefusesAWidthThatIsNotPositive) {
  const results::PowderState powder = powder_of({{0, 0, 0}});
  const results::GrainSolidFraction fraction = fraction_of(powder, [](const auto&) { return 0.5; });
  EXPECT_THROW(GaussianField(powder, fraction, 0), std::invalid_argument);
}

TEST(CylindricalMap, IsConstantForConstantPowder) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder =
      powder_of(lattice_in_ring(ring, kDiameter, [](double) { return 6e-3; }));
  const auto map =
      cylindrical_map(powder, fraction_of(powder, [](const auto&) { return 0.41; }), {}, ring, 5e-4);
  EXPECT_EQ(map.first_unit, "deg");
  EXPECT_EQ(map.second_unit, "mm");
  EXPECT_EQ(map.first.front(), 0);
  EXPECT_EQ(map.first.back(), 360);
  EXPECT_EQ(map.first.size(), 181u);
  EXPECT_EQ(map.second.front(), 0);
  EXPECT_NEAR(map.second.back(), 6, 1e-12);
  EXPECT_EQ(map.averaging_width, 5e-4);
  ASSERT_EQ(map.value.size(), map.first.size() * map.second.size());
  for (const double value : map.value) EXPECT_NEAR(value, 0.41, 1e-14);
}

TEST(CylindricalMap, FollowsAzimuthCounterClockwiseFromWhereTheShoeArrives) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder =
      powder_of(lattice_in_ring(ring, kDiameter, [](double) { return 6e-3; }));
  const auto wave = [](double azimuth) { return 0.4 + 0.05 * std::sin(azimuth * kDegree); };
  const auto map = cylindrical_map(
      powder, fraction_of(powder, [&](const auto& place) { return wave(azimuth_of(ring, place)); }), {}, ring,
      5e-4);
  for (std::size_t j = 0; j < map.second.size(); ++j) {
    for (std::size_t i = 0; i < map.first.size(); ++i) EXPECT_NEAR(at(map, i, j), wave(map.first[i]), 1e-3);
    EXPECT_EQ(at(map, 0, j), at(map, map.first.size() - 1, j));
  }
}

TEST(CylindricalMap, GivesBackALinearGradientInAzimuth) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder =
      powder_of(lattice_in_ring(ring, kDiameter, [](double) { return 6e-3; }));
  const auto ramp = [](double azimuth) { return 0.3 + 0.2 * azimuth / 360; };
  const auto map = cylindrical_map(
      powder, fraction_of(powder, [&](const auto& place) { return ramp(azimuth_of(ring, place)); }), {}, ring,
      5e-4);
  for (std::size_t j = 0; j < map.second.size(); ++j)
    for (std::size_t i = 0; i < map.first.size(); ++i)
      if (map.first[i] > 20 && map.first[i] < 340) {
        EXPECT_NEAR(at(map, i, j), ramp(map.first[i]), 1e-3);
      }
  EXPECT_GT(at(map, 0, 8), 0.33);  // across the step both sides, 0.3 and 0.5, have their say
  EXPECT_LT(at(map, 0, 8), 0.47);
}

TEST(CylindricalMap, ShowsHolesAsHoles) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder = powder_of(lattice_in_ring(
      ring, kDiameter, [](double azimuth) { return azimuth > 90 && azimuth < 150 ? 2e-3 : 6e-3; }));
  const auto map =
      cylindrical_map(powder, fraction_of(powder, [](const auto&) { return 0.4; }), {}, ring, 5e-4);
  for (std::size_t j = 0; j < map.second.size(); ++j)
    for (std::size_t i = 0; i < map.first.size(); ++i) {
      const bool well_inside = map.first[i] > 100 && map.first[i] < 140 && map.second[j] > 3;
      const bool well_outside = map.first[i] < 85 || map.first[i] > 155 || map.second[j] < 1.8;
      if (well_inside) {
        EXPECT_TRUE(std::isnan(at(map, i, j))) << map.first[i] << ' ' << map.second[j];
      }
      if (well_outside) {
        EXPECT_NEAR(at(map, i, j), 0.4, 1e-14) << map.first[i] << ' ' << map.second[j];
      }
    }
}

TEST(CylindricalMap, GoesOnAboveTheFillPlaneWherePowderIsHeaped) {
  const results::CavityState ring = sample_ring();
  const results::PowderState powder =
      powder_of(lattice_in_ring(ring, kDiameter, [](double azimuth) { return azimuth < 90 ? 7e-3 : 6e-3; }));
  const auto map =
      cylindrical_map(powder, fraction_of(powder, [](const auto&) { return 0.4; }), {}, ring, 5e-4);
  EXPECT_GT(map.second.back(), 6.7);
  EXPECT_LT(map.second.back(), 7.5);
  EXPECT_NE(
      std::find_if(map.second.begin(), map.second.end(), [](double z) { return std::abs(z - 6) < 1e-9; }),
      map.second.end());
}

TEST(CylindricalMap, NeedsARing) {
  results::CavityState box = sample_ring();
  box.is_ring = false;
  EXPECT_THROW(cylindrical_map(powder_of({}), {}, {}, box, 5e-4), std::invalid_argument);
}

results::ToolState box_tool(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  results::ToolState tool;
  for (int n = 0; n < 8; ++n)
    tool.vertices.emplace_back((n & 1 ? upper : lower).x(), (n & 2 ? upper : lower).y(),
                               (n & 4 ? upper : lower).z());
  tool.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return tool;
}

TEST(CylindricalMap, LooksNowhereInsideTools) {
  const results::CavityState ring = sample_ring();
  // Dense powder in the inner half up to the rim, loose powder in the outer half on a ledge 3 mm up.
  const double middle = 0.5 * (ring.inner_radius + ring.outer_radius);
  const auto is_inside = [&](const Eigen::Vector3d& place) {
    return (place - ring.axis_origin).head<2>().norm() < middle;
  };
  std::vector<Eigen::Vector3d> places;
  for (const auto& place : lattice_in_ring(ring, kDiameter, [](double) { return 6e-3; }))
    if (is_inside(place) || place.z() > ring.lower_corner.z() + 3e-3 + 0.5 * kDiameter)
      places.push_back(place);
  const results::PowderState powder = powder_of(places);
  const auto fraction = fraction_of(powder, [&](const auto& place) { return is_inside(place) ? 0.5 : 0.2; });
  // Where azimuth is 0 is enough: a ring's walls are looked at there.
  const Eigen::Vector3d axis = ring.axis_origin;
  const double floor = ring.lower_corner.z();
  const results::ToolState ledge = box_tool({axis.x() - 0.05, axis.y() - 0.05, floor - 3e-3},
                                            {axis.x() - middle, axis.y() + 0.05, floor + 3e-3});
  const auto blurred = cylindrical_map(powder, fraction, {}, ring, 5e-4);
  const auto map = cylindrical_map(powder, fraction, {ledge}, ring, 5e-4);
  for (std::size_t j = 0; j < map.second.size(); ++j) {
    if (map.second[j] < 2.9) {
      EXPECT_NEAR(at(map, 0, j), 0.5, 0.05) << map.second[j];
    }
    if (map.second[j] > 3.1) {
      EXPECT_EQ(at(map, 0, j), at(blurred, 0, j)) << map.second[j];
    }
    if (map.second[j] > 2.6 && map.second[j] < 2.9) {
      EXPECT_LT(at(blurred, 0, j), at(map, 0, j) - 0.05) << "where powder on the ledge is near";
    }
  }
}

TEST(PlaneSection, CutsOutTheToolsAndEndsWithThePowder) {
  const results::PowderState powder = powder_of(block(13, kDiameter));  // half edge 3 mm
  const results::ToolState tool = box_tool({1e-3, -1e-3, -1e-3}, {9e-3, 1e-3, 1e-3});
  const results::SectionPlane plane{"middle", {0, 1e-4, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto section =
      plane_section(powder, fraction_of(powder, [](const auto& place) { return 0.4 + 20 * place.x(); }),
                    {tool}, plane, 5e-4);
  EXPECT_EQ(section.plane.name, "middle");
  EXPECT_EQ(section.field.first_name, "x");
  EXPECT_EQ(section.field.second_name, "z");
  EXPECT_NEAR(section.field.first.front(), -4, 1e-9);
  EXPECT_NEAR(section.field.first[1] - section.field.first[0], 0.1, 1e-9);
  int inside = 0, in_tool = 0, outside = 0;
  for (std::size_t j = 0; j < section.field.second.size(); ++j)
    for (std::size_t i = 0; i < section.field.first.size(); ++i) {
      const double x = section.field.first[i], z = section.field.second[j], value = at(section.field, i, j);
      if (x > 1.01 && std::abs(z) < 0.99) {
        ++in_tool;
        EXPECT_TRUE(std::isnan(value));
      } else if (std::abs(x) > 3.76 || std::abs(z) > 3.76) {
        ++outside;
        EXPECT_TRUE(std::isnan(value));
      } else if (std::abs(x) < 0.9 && std::abs(z) < 0.9) {
        ++inside;
        EXPECT_NEAR(value, 0.4 + 0.02 * x, 1e-4);
      }
    }
  EXPECT_GT(inside, 40);
  EXPECT_GT(in_tool, 40);
  EXPECT_GT(outside, 40);
}

TEST(PlaneSection, LooksAtTheCavityWherePowderIsThere) {
  const results::PowderState powder = powder_of(block(13, kDiameter));
  results::GrainSolidFraction fraction = fraction_of(powder, [](const auto&) { return 0.4; });
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    fraction.in_cavity[k] = powder.position[k].z() < -1e-3;
  const results::SectionPlane plane{"", {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto section = plane_section(powder, fraction, {}, plane, 5e-4);
  EXPECT_NEAR(section.field.second.front(), -4, 1e-9);
  EXPECT_NEAR(section.field.second.back(), -0.5, 0.26);  // -1.5 mm, and 2 d more
}

TEST(PlaneSection, OfNoPowderHasNoNodes) {
  const results::PowderState powder = powder_of({{0, 0, 0}});
  const results::SectionPlane plane{"far", {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto section =
      plane_section(powder, fraction_of(powder, [](const auto&) { return 0.4; }), {}, plane, 5e-4);
  EXPECT_TRUE(section.field.value.empty());
}

}  // namespace
}  // namespace diefill::process
