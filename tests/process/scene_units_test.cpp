// Quantities with units: values in SI, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/scene/nearest_key.h"
#include "process/scene/units.h"

namespace diefill::process {
namespace {

struct Quantity {
  const char* text;
  Dimension dimension;
  double value;  // SI
};

class Quantities : public testing::TestWithParam<Quantity> {};

TEST_P(Quantities, AreReadInSiUnits) {
  const double value = parse_quantity(GetParam().text, GetParam().dimension);
  EXPECT_NEAR(value, GetParam().value, 1e-14 * std::abs(GetParam().value)) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Units, Quantities,
    testing::Values(
        Quantity{"1.88 mm", Dimension::length, 1.88e-3}, Quantity{"1.88mm", Dimension::length, 1.88e-3},
        Quantity{"  +1.88   mm ", Dimension::length, 1.88e-3}, Quantity{"150 um", Dimension::length, 1.5e-4},
        Quantity{"150 \u00b5m", Dimension::length, 1.5e-4},  // micro sign
        Quantity{"150 \u03bcm", Dimension::length, 1.5e-4},  // Greek mu
        Quantity{"-3e1 m", Dimension::length, -30}, Quantity{"2 inch", Dimension::length, 0.0508},
        Quantity{"2 us", Dimension::time, 2e-6}, Quantity{"50 ms", Dimension::time, 0.05},
        Quantity{"1 min", Dimension::time, 60}, Quantity{"200 mm/s", Dimension::velocity, 0.2},
        Quantity{"0.2 m/s", Dimension::velocity, 0.2}, Quantity{"10 m/s^2", Dimension::acceleration, 10},
        Quantity{"10 m/s\u00b2", Dimension::acceleration, 10}, Quantity{"76.3 ug", Dimension::mass, 7.63e-8},
        Quantity{"0.0763 mg", Dimension::mass, 7.63e-8}, Quantity{"5 g", Dimension::mass, 5e-3},
        Quantity{"10 MPa", Dimension::pressure, 1e7}, Quantity{"5 mJ/m^2", Dimension::work_of_adhesion, 5e-3},
        Quantity{"5e-3 N/m", Dimension::work_of_adhesion, 5e-3},
        Quantity{"2e-5 Pa s", Dimension::viscosity, 2e-5}, Quantity{"0.02 mPa s", Dimension::viscosity, 2e-5},
        Quantity{"1e6 Pa s/m", Dimension::damping_over_radius, 1e6},
        Quantity{"90 deg", Dimension::angle, std::numbers::pi / 2},
        Quantity{"90\u00b0", Dimension::angle, std::numbers::pi / 2},
        Quantity{"1.5 rad", Dimension::angle, 1.5}));

class WrongQuantities : public testing::TestWithParam<Quantity> {};

TEST_P(WrongQuantities, AreRefused) {
  EXPECT_THROW(parse_quantity(GetParam().text, GetParam().dimension), UnitError) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Units, WrongQuantities,
    testing::Values(Quantity{"", Dimension::length, 0}, Quantity{"mm", Dimension::length, 0},
                    Quantity{"1.88", Dimension::length, 0}, Quantity{"1.88 mm^2", Dimension::length, 0},
                    Quantity{"1.88 1/mm", Dimension::length, 0}, Quantity{"1,88 mm", Dimension::length, 0},
                    Quantity{"0x10 mm", Dimension::length, 0}, Quantity{"nan mm", Dimension::length, 0},
                    Quantity{"-inf mm", Dimension::length, 0}, Quantity{"1e308 km", Dimension::length, 0},
                    Quantity{"50 Hz", Dimension::time, 0}, Quantity{"5 s/m", Dimension::velocity, 0},
                    Quantity{"1 Pa s", Dimension::damping_over_radius, 0},
                    Quantity{"5 kg", Dimension::pressure, 0}, Quantity{"3 mm", Dimension::angle, 0},
                    Quantity{"1 lumps", Dimension::mass, 0}, Quantity{"1 J", Dimension::work_of_adhesion, 0},
                    Quantity{"20 celsius", Dimension::length, 0}));

TEST(Units, ExamplesOfEveryDimensionCanBeRead) {
  for (const Dimension dimension :
       {Dimension::length, Dimension::time, Dimension::velocity, Dimension::acceleration, Dimension::mass,
        Dimension::pressure, Dimension::work_of_adhesion, Dimension::viscosity,
        Dimension::damping_over_radius, Dimension::angle}) {
    EXPECT_GT(parse_quantity(example_of(dimension), dimension), 0) << in_words(dimension);
  }
}

TEST(Units, UnknownUnitLeavesStandardErrorEmpty) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(parse_quantity("3 blobs", Dimension::length), UnitError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(NearestKey, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("Fill-Height", "fill_height"), 0U);
}

TEST(NearestKey, FindsTheMeantKeyAndLeavesStrangersAlone) {
  const std::vector<std::string> known = {"friction", "rolling_friction", "grain_mass"};
  EXPECT_EQ(nearest_key("frictoin", known), "friction");
  EXPECT_EQ(nearest_key("rollingfriction", known), "rolling_friction");
  EXPECT_EQ(nearest_key("colour", known), std::nullopt);
  EXPECT_EQ(nearest_key("x", {"y"}), std::nullopt);
}

}  // namespace
}  // namespace diefill::process
