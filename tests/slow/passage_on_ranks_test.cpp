// A passage of the shoe fills the die alike on ranks and without: its motion is chaotic, so figures of
// several packings are compared.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

constexpr int kSeeds = 8;
constexpr double kStudent = 4.14;  // exceeded by chance once in a thousand, of two samples of eight each

/// A figure of each seed.
using Sample = std::vector<double>;

double mean(const Sample& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about_mean(const Sample& values) {
  double sum = 0;
  for (const double value : values) sum += (value - mean(values)) * (value - mean(values));
  return sum;
}

/// Expects the means to differ by no more than the scatter over seeds explains.
void expect_alike(const Sample& one, const Sample& other, const std::string& figure) {
  const auto count = static_cast<double>(one.size() + other.size());
  const double deviation = std::sqrt((squares_about_mean(one) + squares_about_mean(other)) / (count - 2));
  ASSERT_GT(deviation, 0) << figure;
  EXPECT_LT(std::abs(mean(one) - mean(other)), kStudent * deviation * std::sqrt(4 / count))
      << figure << ": " << ::testing::PrintToString(one) << " and " << ::testing::PrintToString(other);
}

/// Figures of the die filled with each seed, by name.
std::map<std::string, Sample> filled(const std::vector<std::string>& options) {
  std::map<std::string, Sample> figures;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const SmallDie die;
    die.exchange("seed = 1", "seed = " + std::to_string(seed));
    // Fine enough for a solid fraction two diameters below the surface.
    die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.75 mm\"");
    die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.2 mm\"");
    const Outcome outcome = die.run(options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    if (outcome.exit_code != 0) return {};
    const auto report = die.report();
    figures["filled mass"].push_back(report["filled_mass_kg"]);
    figures["mean solid fraction"].push_back(report["solid_fraction"]["mean"]);
    figures["evenness"].push_back(report["solid_fraction"]["std"]);
  }
  return figures;
}

TEST(PassageOnRanks, FillsTheDieWithinTheScatterOverSeeds) {
  const auto built_in = filled({"--quiet"}), on_ranks = filled({"--quiet", "--ranks", "2"});
  ASSERT_EQ(built_in.size(), 3U);
  ASSERT_EQ(on_ranks.size(), 3U);
  for (const auto& [figure, sample] : built_in) expect_alike(sample, on_ranks.at(figure), figure);
}

}  // namespace
}  // namespace diefill::app
