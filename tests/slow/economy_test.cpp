// How little it changes what a scene does not compute: filled masses over several seeds.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// The small die's scene with lines of [economy].
struct Economical : SmallDie {
  explicit Economical(const std::string& lines) {
    exchange("[numerics]", "[economy]\n" + lines + "\n\n[numerics]");
  }
  /// Perhaps of an earlier run.
  nlohmann::json report_of_filling() const { return shared_report(*this); }
};

double number(const nlohmann::json& report, const char* key) {
  return report.at(key).get<double>();
}

/// Filled masses (kg) of the same scene with several seeds.
struct Fillings {
  std::vector<double> masses;
  double mean = 0, variance = 0;  ///< kg, kg^2

  explicit Fillings(const std::string& lines, const std::string& grain_diameter = "1 mm", int seeds = 4) {
    for (int seed = 1; seed <= seeds; ++seed) {
      const Economical die(lines);
      die.exchange("seed = 1", "seed = " + std::to_string(seed));
      die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"" + grain_diameter + "\"");
      masses.push_back(number(die.report_of_filling(), "filled_mass_kg"));
      mean += masses.back() / seeds;
    }
    for (const double mass : masses) variance += (mass - mean) * (mass - mean) / (seeds - 1);
  }
};

/// The difference of the means is within three standard errors of the scatter over `seeds`.
void expect_same_filling(const std::string& lines, int seeds = 4) {
  const Fillings plain_fillings("", "1 mm", seeds), economical(lines, "1 mm", seeds);
  const double error = std::sqrt((plain_fillings.variance + economical.variance) / seeds);
  EXPECT_NEAR(economical.mean, plain_fillings.mean, 3 * error);
  EXPECT_LT(3 * error, 0.1 * plain_fillings.mean) << "the scatter is small enough to see something";
}

TEST(Economy, SleepFillsThePocketAsWell) {
  expect_same_filling("sleep = true", 20);
}

TEST(Economy, ComovingPowderFillsThePocketAsWell) {
  expect_same_filling("carry_beyond = \"2 mm\"", 20);
}

TEST(Economy, SpilledGrainsThatAreKeptChangeNoFilling) {
  expect_same_filling("drop_spilled = false", 20);
}

TEST(Economy, HalfModelStandsForTheWhole) {
  // Half the pocket must be a few grains wide: with two (d = 1 mm) it fills by more than a quarter less.
  const Fillings whole("", "0.6 mm"), halves("mirror = \"y\"", "0.6 mm");
  EXPECT_NEAR(halves.mean, whole.mean, 0.12 * whole.mean);
}

}  // namespace
}  // namespace diefill::app
