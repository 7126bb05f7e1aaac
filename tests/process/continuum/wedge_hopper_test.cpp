// Jenike's hopper design against values that follow from the published shear tests (Kottlan 2018, section
// 3.4).
#include "process/continuum/wedge_hopper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace diefill::process::continuum {
namespace {

const ShearTest kMeasured220 = {3e3, 2.88e3, 0.796, 0.88e3, 20.03, 0.38 * 1545};
const ShearTest kPredicted100 = {3e3, 1.91e3, 0.586, 0.184e3, 7.77, 0.6 * 1545};

TEST(WedgeHopper, OfMeasuredFineLactoseHasTheHalfAngleOfTheSource) {
  const WedgeHopper hopper = wedge_hopper(kMeasured220);
  EXPECT_NEAR(hopper.effective_angle, 54.4, 0.05);
  EXPECT_NEAR(hopper.half_angle, 34.3, 0.05);
  EXPECT_NEAR(hopper.flow_factor, 1.16, 0.005);
  EXPECT_NEAR(hopper.strength, 3.65e3, 5);
  EXPECT_NEAR(hopper.slot_width, 0.74, 0.01);
}

TEST(WedgeHopper, OfCoarseLactoseHasASlotOfTheSourcesOrder) {
  const WedgeHopper hopper = wedge_hopper(kPredicted100);
  EXPECT_NEAR(hopper.effective_angle, 33.2, 0.05);
  EXPECT_NEAR(hopper.strength, 0.642e3, 1);
  EXPECT_NEAR(hopper.slot_width, 0.09, 0.005);
}

TEST(WedgeHopper, SlotGrowsWithStrengthAndHalfAngleFallsWithWallFriction) {
  ShearTest sticky = kPredicted100, rough = kPredicted100;
  sticky.cohesion *= 2;
  rough.wall_angle += 5;
  const WedgeHopper plain = wedge_hopper(kPredicted100);
  EXPECT_GT(wedge_hopper(sticky).slot_width, plain.slot_width);
  EXPECT_LT(wedge_hopper(rough).half_angle, plain.half_angle);
}

TEST(WedgeHopper, PreShearAboveTheLocusTouchesItThere) {
  // 2.39 > 0.457 * 3 + 0.763: no circle through that point is tangent.
  const ShearTest above = {3e3, 2.39e3, 0.457, 0.763e3, 20.03, 0.38 * 1545};
  ShearTest touching = above;
  touching.preshear = 0.457 * 3e3 + 0.763e3;
  EXPECT_NEAR(wedge_hopper(above).effective_angle, wedge_hopper(touching).effective_angle, 1e-4);
}

TEST(WedgeHopper, RefusesNumbersThatAreNotPositive) {
  ShearTest none = kPredicted100;
  none.bulk_density = 0;
  EXPECT_THROW(wedge_hopper(none), std::invalid_argument);
  none = kPredicted100;
  none.slope = std::nan("");
  EXPECT_THROW(wedge_hopper(none), std::invalid_argument);
}

/// What is said of a powder with this wall angle.
std::string refusal(ShearTest test, double wall_angle) {
  test.wall_angle = wall_angle;
  try {
    wedge_hopper(test);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(WedgeHopper, RefusesWallsAlongWhichThePowderDoesNotSlide) {
  // phi_e is 33.2 deg.
  EXPECT_EQ(refusal(kPredicted100, 30), "none");
  for (const double angle : {33.3, 40.0, 89.0})
    EXPECT_NE(refusal(kPredicted100, angle).find("allowed: less than 33.2 deg"), std::string::npos)
        << refusal(kPredicted100, angle);
  // phi_e is 54.4 deg: up to exp(3.75 * 1.01^2.44) = 46.7 deg there is a half angle.
  EXPECT_EQ(refusal(kMeasured220, 46), "none");
  EXPECT_NE(refusal(kMeasured220, 48).find("its half angle would be -"), std::string::npos)
      << refusal(kMeasured220, 48);
}

}  // namespace
}  // namespace diefill::process::continuum
