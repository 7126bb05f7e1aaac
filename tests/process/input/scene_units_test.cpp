// Quantities with units: values in SI, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "process/input/nearest_key.h"
#include "process/input/numbers_apart.h"
#include "process/input/units.h"

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
        Quantity{"1.5 rad", Dimension::angle, 1.5}, Quantity{"0.2 m s-1", Dimension::velocity, 0.2},
        Quantity{"0.2 m.s-1", Dimension::velocity, 0.2}, Quantity{"0.2 m*s^-1", Dimension::velocity, 0.2},
        Quantity{"0.2 m s**-1", Dimension::velocity, 0.2},
        Quantity{"0.2 m\u00b7s\u207b\u00b9", Dimension::velocity, 0.2},
        Quantity{"0.2 m per s", Dimension::velocity, 0.2}, Quantity{"12 m/min", Dimension::velocity, 0.2},
        Quantity{"10 m/(s s)", Dimension::acceleration, 10}, Quantity{"10 m/s2", Dimension::acceleration, 10},
        Quantity{"3 g/cm^3", Dimension::density, 3000}, Quantity{"3 g cm-3", Dimension::density, 3000},
        Quantity{"5 N/m", Dimension::work_of_adhesion, 5}, Quantity{"0.02 N-m", Dimension::torque, 0.02},
        Quantity{"1 cmH2O", Dimension::pressure, 98.0665}, Quantity{"32 1/s", Dimension::frequency, 32},
        Quantity{"1e3 mm", Dimension::length, 1}, Quantity{"2.82\u00a0mm", Dimension::length, 2.82e-3},
        Quantity{"2.82\u202fmm", Dimension::length, 2.82e-3},
        Quantity{"\u22123 mm", Dimension::length, -3e-3},
        Quantity{"60 rpm", Dimension::angular_velocity, 2 * std::numbers::pi},
        Quantity{"90 deg/s", Dimension::angular_velocity, std::numbers::pi / 2}));

class WrongQuantities : public testing::TestWithParam<Quantity> {};

TEST_P(WrongQuantities, AreRefused) {
  EXPECT_THROW(parse_quantity(GetParam().text, GetParam().dimension), UnitError) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Units, WrongQuantities,
    testing::Values(
        Quantity{"", Dimension::length, 0}, Quantity{"mm", Dimension::length, 0},
        Quantity{"1.88", Dimension::length, 0}, Quantity{"1.88 mm^2", Dimension::length, 0},
        Quantity{"1.88 1/mm", Dimension::length, 0}, Quantity{"1,88 mm", Dimension::length, 0},
        Quantity{"0x10 mm", Dimension::length, 0}, Quantity{"nan mm", Dimension::length, 0},
        Quantity{"-inf mm", Dimension::length, 0}, Quantity{"1e308 km", Dimension::length, 0},
        Quantity{"50 Hz", Dimension::time, 0}, Quantity{"5 s/m", Dimension::velocity, 0},
        Quantity{"1 Pa s", Dimension::damping_over_radius, 0}, Quantity{"5 kg", Dimension::pressure, 0},
        Quantity{"3 mm", Dimension::angle, 0}, Quantity{"1 lumps", Dimension::mass, 0},
        Quantity{"1 J", Dimension::work_of_adhesion, 0}, Quantity{"20 celsius", Dimension::length, 0},
        Quantity{"2 820 um", Dimension::length, 0}, Quantity{"2\u202f820 um", Dimension::length, 0},
        Quantity{"2\u00a0820 um", Dimension::length, 0}, Quantity{"2'820 um", Dimension::length, 0},
        Quantity{"2_820 um", Dimension::length, 0}, Quantity{"2.82 10 mm", Dimension::length, 0},
        Quantity{"1.3 mm 2", Dimension::length, 0}, Quantity{"1.3 2 mm", Dimension::length, 0},
        Quantity{"1.3 (2 mm)", Dimension::length, 0}, Quantity{"1.3 mm (2)", Dimension::length, 0},
        Quantity{"1.3 mm*2", Dimension::length, 0}, Quantity{"1.3 mm/2", Dimension::length, 0},
        Quantity{"1.3 mm.2", Dimension::length, 0}, Quantity{"1.3 mm .2", Dimension::length, 0},
        Quantity{"1.3 mm 1e1", Dimension::length, 0}, Quantity{"1.3*2 mm", Dimension::length, 0},
        Quantity{"1.3/2 mm", Dimension::length, 0}, Quantity{"1.3 \u00d7 10^-3 m", Dimension::length, 0},
        Quantity{"1.3 1/1 mm", Dimension::length, 0}, Quantity{"2.82 mm @ 3", Dimension::length, 0},
        Quantity{"2.82 mm@3", Dimension::length, 0}, Quantity{"2.82 mm since 1", Dimension::length, 0},
        Quantity{"2.82 mm from 1", Dimension::length, 0}, Quantity{"2.82 mm after 1", Dimension::length, 0},
        Quantity{"2.82 mm ref 1", Dimension::length, 0}, Quantity{"2.82 mm FROM 1", Dimension::length, 0},
        Quantity{"2.82 s since 2000-01-01", Dimension::time, 0},
        Quantity{"2.82 mm + 1 mm", Dimension::length, 0}, Quantity{"2.82 mm - 1", Dimension::length, 0},
        Quantity{"2.82 mm -1", Dimension::length, 0}, Quantity{"2.82 mm +1", Dimension::length, 0},
        Quantity{"2.82 lg(re 1 mm)", Dimension::length, 0}, Quantity{"2.82 ln(re mm)", Dimension::length, 0},
        Quantity{"2.82 lb (re mm)", Dimension::length, 0}, Quantity{"2 dozen mm", Dimension::length, 0},
        Quantity{"2 percent mm", Dimension::length, 0}, Quantity{"2 % mm", Dimension::length, 0},
        Quantity{"2 ppm m", Dimension::length, 0}, Quantity{"2 pi mm", Dimension::length, 0},
        Quantity{"2 mm deg", Dimension::length, 0}, Quantity{"2 mm deg/rad", Dimension::length, 0},
        Quantity{"2 rad mm", Dimension::length, 0}, Quantity{"2 celsius mm/K", Dimension::length, 0},
        Quantity{"2 mm^0", Dimension::length, 0}, Quantity{"2 mm m^0", Dimension::length, 0},
        Quantity{"2 mm^1.0", Dimension::length, 0}, Quantity{"2 mm^", Dimension::length, 0},
        Quantity{"2 mm^99999999999", Dimension::length, 0}, Quantity{"2 (mm", Dimension::length, 0},
        Quantity{"2 mm)", Dimension::length, 0}, Quantity{"2 ()", Dimension::length, 0},
        Quantity{"2 mm\nm", Dimension::length, 0}, Quantity{"2 mm per", Dimension::length, 0},
        Quantity{"2 /s", Dimension::frequency, 0}, Quantity{"2 \u00b2", Dimension::length, 0},
        Quantity{"2 mm \xff", Dimension::length, 0}, Quantity{"60 rpm", Dimension::frequency, 0},
        Quantity{"5 Hz", Dimension::angular_velocity, 0}, Quantity{"0.2 m Hz Hz", Dimension::velocity, 0}));

/// What is said of a text that is no length.
std::string complaint(const std::string& text) {
  try {
    parse_quantity(text, Dimension::length);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

TEST(Units, RefusalsSayWhatIsWrong) {
  EXPECT_EQ(complaint("2 820 um").find("write the number without spaces, as 2820; "), 0U)
      << complaint("2 820 um");
  EXPECT_EQ(complaint("1 234 567 um").find("write the number without spaces, as 1234567; "), 0U);
  EXPECT_EQ(complaint("2.82 10 mm").find("found a second number, \"10 mm\""), 0U) << complaint("2.82 10 mm");
  EXPECT_EQ(complaint("1.3 mm 2").find("found a second number, \"2\""), 0U) << complaint("1.3 mm 2");
  EXPECT_EQ(complaint("2 82 um").find("found a second number, \"82 um\""), 0U) << complaint("2 82 um");
  EXPECT_EQ(complaint("2.82 mm @ 3").find("\"@ 3\" is not a unit"), 0U) << complaint("2.82 mm @ 3");
  EXPECT_EQ(complaint("2 dozen mm").find("the unit \"dozen\" is not known"), 0U) << complaint("2 dozen mm");
  EXPECT_EQ(complaint("2 percent mm").find("\"percent\" is a number, not a unit"), 0U)
      << complaint("2 percent mm");
  EXPECT_EQ(complaint("2,82 mm").find("write a decimal point, not a comma"), 0U) << complaint("2,82 mm");
}

// A null byte ends a text for the library of units, not for us.
TEST(Units, NothingHidesBehindANullByte) {
  EXPECT_THROW(parse_quantity(std::string("2 mm\0 5", 7), Dimension::length), UnitError);
}

TEST(Units, TwoNumbersInWordsDiffer) {
  EXPECT_EQ(numbers_apart(6.0000001, 6), (std::pair<std::string, std::string>("6.0000001", "6")));
  EXPECT_EQ(numbers_apart(7, 6), (std::pair<std::string, std::string>("7", "6")));
}

TEST(Units, ExamplesOfEveryDimensionCanBeRead) {
  for (const Dimension dimension :
       {Dimension::length, Dimension::time, Dimension::velocity, Dimension::acceleration, Dimension::mass,
        Dimension::pressure, Dimension::work_of_adhesion, Dimension::viscosity,
        Dimension::damping_over_radius, Dimension::angle}) {
    EXPECT_GT(parse_quantity(example_of(dimension), dimension), 0) << description(dimension);
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

TEST(NearestKey, CountsTwoSwappedLettersOnce) {
  EXPECT_EQ(edit_distance("fiel", "file"), 1U);
  EXPECT_EQ(edit_distance("form", "from"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // letters that were swapped are not changed again
  EXPECT_EQ(nearest_key("form", {"key", "from", "to"}), "from");
}

TEST(NearestKey, FindsTheMeantKeyAndLeavesStrangersAlone) {
  const std::vector<std::string> known = {"friction", "rolling_friction", "grain_mass"};
  EXPECT_EQ(nearest_key("frictoin", known), "friction");
  EXPECT_EQ(nearest_key("rollingfriction", known), "rolling_friction");
  EXPECT_EQ(nearest_key("colour", known), std::nullopt);
  EXPECT_EQ(nearest_key("x", {"y"}), std::nullopt);
  // A beginning of one word alone.
  EXPECT_EQ(nearest_key("numeri", {"powder", "numerics", "measure"}), "numerics");
  EXPECT_EQ(nearest_key("VIB", {"move", "vibration", "passage"}), "vibration");
  EXPECT_EQ(nearest_key("frictio", {"friction", "frictionless"}), "friction");  // the nearest of several
  EXPECT_EQ(nearest_key("averaging", {"averaging_width", "averaging_time_of_the_run"}), std::nullopt);
  EXPECT_EQ(nearest_key("vi", {"vibration"}), std::nullopt);
  EXPECT_EQ(nearest_key(std::string(1000000, 'x'), {std::string(1000000, 'x') + 'y'}), std::nullopt);
}

}  // namespace
}  // namespace diefill::process
