// Forces across gaps: van der Waals cut-offs, liquid bridges that form at touch and break at rupture.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kRadius = 2.5e-4;

TEST(VanDerWaalsPart, FollowsTheInverseSquareBetweenItsCutOffs) {
  const auto pair = spheres(1e-5, 3e-5);
  const VanDerWaals part({.hamaker = 5e-18, .smallest_gap = 5e-9, .largest_gap = 1e-6}, pair);
  const double effective = 2 * 0.75e-5;
  for (const double gap : {5e-9, 2e-8, 1e-6})
    EXPECT_NEAR(part.force(gap, nullptr), -5e-18 * effective / (6 * gap * gap),
                1e-13 * 5e-18 * effective / (gap * gap));
  const double most = part.force(5e-9, nullptr);
  for (const double gap : {4.9e-9, 0.0, -1e-7}) EXPECT_EQ(part.force(gap, nullptr), most);
  EXPECT_EQ(part.force(1.0000001e-6, nullptr), 0);
  EXPECT_EQ(part.range(), 1e-6);
  const VanDerWaals derjaguin({.hamaker = 5e-18, .harmonic_mean = false}, pair);
  EXPECT_DOUBLE_EQ(2 * derjaguin.force(5e-9, nullptr), most);
}

TEST(VanDerWaalsPart, EnergyIsIntegralOfForce) {
  const VanDerWaals part({.hamaker = 5e-18}, spheres(1e-5, 1e-5));
  for (const double gap : {-3e-8, 0.0, 2e-9, 5e-9, 1e-7, 9e-7}) {
    const double step = 1e-3 * 5e-9;
    const double slope = (part.energy(gap + step, nullptr) - part.energy(gap - step, nullptr)) / (2 * step);
    EXPECT_NEAR(slope, -part.force(gap, nullptr), 2e-3 * slope) << gap;
  }
  EXPECT_NEAR(part.energy(1e-6, nullptr), 0, 1e-30);
}

TEST(VanDerWaalsPart, WallsPullOnTouchOnly) {
  const auto wall = sphere_on_wall(1e-5);
  const VanDerWaals part({.hamaker = 5e-18}, wall);
  EXPECT_EQ(part.range(), 0);
  EXPECT_EQ(part.force(1e-10, nullptr), 0);
  EXPECT_NEAR(part.force(-1e-10, nullptr), -5e-18 * 2e-5 / (6 * 25e-18), 1e-18);
  EXPECT_EQ(part.energy(1e-10, nullptr), 0);
  EXPECT_NEAR(part.energy(-1e-8, nullptr), part.force(-1e-8, nullptr) * 1e-8, 1e-25);
  const VanDerWaals distant({.hamaker = 5e-18, .walls_at_distance = true}, wall);
  EXPECT_LT(distant.force(1e-10, nullptr), 0);
  EXPECT_EQ(distant.range(), 1e-6);
}

// d = 0.5 mm, a_1 = 0.05, gamma_L = 0.1 N/m (Hu 2024, chapter 4).
const CapillaryBridge::Parameters kWet{.surface_tension = 0.1};

TEST(CapillaryBridgePart, HasHusAnchors) {
  const auto pair = spheres(kRadius, kRadius);
  const CapillaryBridge part(kWet, pair);
  EXPECT_NEAR(CapillaryBridge::bridge_volume(kWet, pair), 5.43234e-13, 1e-18);
  EXPECT_NEAR(part.range(), 8.15948e-5, 1e-10);
  double history = 0;
  part.force(0, &history);
  EXPECT_NEAR(part.force(1e-6, &history), -1.52858e-4, 1e-9);
  EXPECT_NEAR(part.force(1e-5, &history), -1.16294e-4, 1e-9);
  EXPECT_NEAR(part.force(5e-5, &history), -3.10457e-5, 1e-10);
  EXPECT_NEAR(part.force(part.range(), &history), -1.41487e-5, 1e-10);
  EXPECT_EQ(part.force(-1e-6, &history), part.force(1e-6, &history));
}

TEST(CapillaryBridgePart, IsRabinovichsFormula) {
  const auto pair = spheres(kRadius, 3 * kRadius);
  const auto wet = CapillaryBridge::Parameters{.surface_tension = 0.07, .contact_angle = 0.5};
  const CapillaryBridge part(wet, pair);
  const double radius = pair.effective_radius(), volume = CapillaryBridge::bridge_volume(wet, pair);
  EXPECT_NEAR(part.range(), 1.25 * std::cbrt(volume), 1e-18);
  double history = 1;
  for (const double gap : {2e-6, 2e-5, 1e-4}) {
    const double immersion =
        0.5 * gap * (-1 + std::sqrt(1 + volume / (std::numbers::pi * radius * gap * gap)));
    const double expected =
        4 * std::numbers::pi * radius * 0.07 * std::cos(0.5) / (1 + gap / (2 * immersion));
    EXPECT_NEAR(part.force(gap, &history), -expected, 1e-12 * expected);
  }
}

TEST(CapillaryBridgePart, FormsOnTouchAndBreaksForGood) {
  const CapillaryBridge part(kWet, spheres(kRadius, kRadius));
  double history = 0;
  for (const double gap : {5e-5, 1e-5, 1e-9}) EXPECT_EQ(part.force(gap, &history), 0);  // coming closer
  EXPECT_LT(part.force(0, &history), 0);
  for (const double gap : {-1e-6, 1e-5, 8.1e-5}) EXPECT_LT(part.force(gap, &history), 0);
  EXPECT_EQ(part.force(8.2e-5, &history), 0);  // ruptured
  for (const double gap : {8.1e-5, 1e-5, 1e-9}) EXPECT_EQ(part.force(gap, &history), 0);
  EXPECT_LT(part.force(0, &history), 0);
}

TEST(CapillaryBridgePart, EnergyIsIntegralOfForce) {
  const CapillaryBridge part(kWet, spheres(kRadius, kRadius));
  double history = 1;
  for (const double gap : {-1e-6, 5e-7, 3e-6, 4e-5, 8e-5}) {
    const double step = 1e-9;
    const double slope = (part.energy(gap + step, &history) - part.energy(gap - step, &history)) / (2 * step);
    EXPECT_NEAR(slope, -part.force(gap, &history), 1e-6 * slope);
  }
  EXPECT_NEAR(part.energy(part.range(), &history), 0, 1e-25);
  history = 0;
  EXPECT_EQ(part.energy(1e-6, &history), 0);
}

TEST(CapillaryBridgePart, HasNoneOnWallsAndNoneWhenDry) {
  double history = 0;
  const CapillaryBridge on_wall(kWet, sphere_on_wall(kRadius));
  EXPECT_EQ(on_wall.force(-1e-6, &history), 0);
  EXPECT_EQ(on_wall.range(), 0);
  auto dry = kWet;
  dry.liquid_fraction = 0;
  const CapillaryBridge none(dry, spheres(kRadius, kRadius));
  EXPECT_EQ(none.force(-1e-6, &history), 0);
  EXPECT_EQ(none.energy(-1e-6, &history), 0);
}

/// Force over 2 pi gamma_L r_p and volume over that of one sphere of a toroidal bridge, contact angle 0,
/// filling half angle psi, gap 2 r_p h (Hu 2024, Eqs. 2.34, 2.39 to 2.41).
std::pair<double, double> toroidal_bridge(double psi, double h) {
  const double c = std::cos(psi), s = std::sin(psi);
  const double r1 = (1 + h - c) / c, r2 = ((1 + h) * (s - 1) + c) / c, sum = r1 + r2;
  const double volume = 1.5 * ((sum * sum + r1 * r1) * r1 * c - sum * r1 * r1 * s * c -
                               r1 * r1 * sum * (std::numbers::pi / 2 - psi) - (1 + h) * r1 * r1 * c * c +
                               h * (h + 2) * r1 * c - h * h * (h + 3) / 3);
  return {r2 * sum / (2 * r1), volume};
}

TEST(CapillaryBridgePart, AgreesWithTheToroidalBridge) {
  for (const double h : {5e-4, 2e-3, 5e-3, 1e-2}) {
    const auto [theory, volume] = toroidal_bridge(0.1, h);
    auto wet = CapillaryBridge::Parameters{.surface_tension = 1, .smallest_gap = 1e-9};
    wet.liquid_fraction = volume / (2 * wet.bridge_share);
    const CapillaryBridge part(wet, spheres(1, 1));
    double history = 1;
    EXPECT_NEAR(-part.force(2 * h, &history) / (2 * std::numbers::pi), theory, 0.05 * theory) << h;
  }
}

}  // namespace
}  // namespace diefill::engine::laws
