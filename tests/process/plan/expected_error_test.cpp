// Expected errors against the runs that they were measured on.
#include "process/plan/expected_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "process/plan/grain_size_trends.h"
#include "process/scene/powder/powder_presets.h"
#include "project_paths.h"

namespace diefill::process::plan {
namespace {

/// One run of the table: d/b, a figure, and the solid fraction of the cavity.
struct Run {
  double share, value, filled;
};

constexpr std::size_t kFilled = 6, kUnevenness = 7, kMean = 9, kWalls = 10;  // columns of the table

/// The runs of one cavity, with "(mesh)" after its name or not, and powder; `column`: of the figure.
std::vector<Run> runs_of(const std::string& cavity, const std::string& powder, std::size_t column) {
  std::ifstream file(std::string(DIEFILL_SOURCE_DIR) + "/process/plan/grain_size_errors.csv");
  std::vector<Run> runs;
  const std::string die = cavity.substr(0, cavity.find(" (mesh)"));
  const std::string walls = die == cavity ? "spheres" : "mesh";
  for (std::string line; std::getline(file, line);) {
    if (line.find("/" + die + ".toml," + powder + ",") == std::string::npos) continue;
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (cells.at(kWalls) != walls || cells.at(column).empty()) continue;  // empty: too few grains
    runs.push_back({std::stod(cells.at(3)), std::stod(cells.at(column)), std::stod(cells.at(kFilled))});
  }
  return runs;
}

struct Line {
  double limit = 0, slope = 0, scatter = 0, slope_error = 0;
};

Line line_through(const std::vector<Run>& runs, double Run::*figure) {
  const auto count = static_cast<double>(runs.size());
  double x = 0, y = 0, xx = 0, xy = 0, left = 0;
  for (const Run& run : runs) {
    x += run.share / count;
    y += run.*figure / count;
  }
  for (const Run& run : runs) {
    xx += (run.share - x) * (run.share - x);
    xy += (run.share - x) * (run.*figure - y);
  }
  Line line{y - xy / xx * x, xy / xx, 0, 0};
  for (const Run& run : runs) left += std::pow(run.*figure - line.limit - line.slope * run.share, 2);
  line.scatter = std::sqrt(left / (count - 2));
  line.slope_error = line.scatter / std::sqrt(xx);
  return line;
}

TEST(ExpectedError, TrendsAreThoseOfTheTable) {
  ASSERT_FALSE(grain_size_trends().empty());
  for (const GrainSizeTrend& trend : grain_size_trends()) {
    const std::string figure = trend.figure;
    const std::size_t column = figure == "mass of a full cavity" ? kFilled
                               : figure == "unevenness"          ? kUnevenness
                                                                 : kMean;
    const auto runs = runs_of(trend.scene, trend.powder, column);
    ASSERT_EQ(runs.size(), static_cast<std::size_t>(trend.runs)) << trend.scene << trend.powder;
    const Line line = line_through(runs, &Run::value);
    const double over = line_through(runs_of(trend.scene, trend.powder, kFilled), &Run::filled).limit;
    EXPECT_NEAR(trend.slope, line.slope / over, 1e-4) << trend.scene << trend.powder << figure;
    EXPECT_NEAR(trend.scatter, line.scatter / over, 1e-4) << trend.scene << trend.powder << figure;
    EXPECT_NEAR(trend.slope_error, line.slope_error / over, 1e-4) << trend.scene << trend.powder << figure;
    EXPECT_LT(trend.finest, trend.coarsest);
  }
}

/// The error of one quantity; null where it is not told.
const ExpectedError* error_of(const std::vector<ExpectedError>& errors, const std::string& quantity) {
  for (const ExpectedError& error : errors)
    if (error.quantity == quantity) return &error;
  return nullptr;
}

TEST(ExpectedError, GrowsWithTheGrainSizeUpToTheCoarsestThatWasRun) {
  const PowderSpec powder = powder_preset("Distaloy AE");
  const double width = 6e-3;
  const auto fine = expected_errors(powder, 0.2 * width, {width}),
             coarse = expected_errors(powder, 0.4 * width, {width});
  for (const char* quantity : {"mass of a full cavity", "unevenness"}) {
    ASSERT_TRUE(error_of(fine, quantity) && error_of(coarse, quantity)) << quantity;
    EXPECT_GT(error_of(coarse, quantity)->error, 0);
    EXPECT_GT(error_of(coarse, quantity)->scatter, 0);
    EXPECT_NE(error_of(coarse, quantity)->source.find("grain_size_errors.csv"), std::string::npos);
  }
  EXPECT_NEAR(error_of(coarse, "mass of a full cavity")->error,
              0.4 / 0.2 * error_of(fine, "mass of a full cavity")->error, 1e-12);
  EXPECT_TRUE(error_of(fine, "mean solid fraction"));
  EXPECT_TRUE(expected_errors(powder, 0.9 * width, {width}).empty());
  EXPECT_TRUE(expected_errors(powder, 1e-3, {}).empty());  // no cavity, no published bed
}

// In a square of 8 mm, where coarse grains leave too few cells for a mean solid fraction (0.33 is the
// coarsest).
TEST(ExpectedError, OfTheMeanSolidFractionGrowsBeyondTheCoarsestGrainsThatHaveIt) {
  const PowderSpec powder = powder_preset("Distaloy AE");
  const auto mean_at = [&](double diameter) {
    return *error_of(expected_errors(powder, diameter, {8e-3}), "mean solid fraction");
  };
  const double line = std::hypot(-0.0899, 0.1105);  // of the square with walls of triangles
  for (const double diameter : {1.88e-3, 2.64e-3, 8e-3 / 3, 2.993e-3, 3.8e-3})
    EXPECT_NEAR(mean_at(diameter).error, line * diameter / 8e-3, 1e-12) << diameter;
  EXPECT_EQ(mean_at(8e-3 / 3).extrapolated_beyond, 0) << "a third counts as 0.33";
  EXPECT_EQ(mean_at(2.993e-3).extrapolated_beyond, 0.33);
  EXPECT_NE(mean_at(2.993e-3).source.find("square (mesh), extrapolated beyond d/b = 0.33 (process"),
            std::string::npos)
      << mean_at(2.993e-3).source;
  EXPECT_TRUE(expected_errors(powder, 4e-3, {8e-3}).empty()) << "coarser than any that was run";
}

TEST(ExpectedError, NeverFallsAsGrainsGetCoarser) {
  const SceneLengths scenes[] = {{1, 0, 0, false}, {0, 1, 0, false}, {0, 0, 1, true}};
  PowderSpec unknown = powder_preset("Distaloy AE");
  unknown.friction = 0.1;
  for (const PowderSpec& powder :
       {powder_preset("Distaloy AE"), powder_preset("ASC100.29 D2"), powder_preset("ASC100.29 D1"), unknown})
    for (const SceneLengths& lengths : scenes) {
      std::map<std::string, double> before;
      for (double share = 0.005; share < 0.4944; share += 0.001)
        for (const ExpectedError& error : expected_errors(powder, share, lengths)) {
          if (error.quantity == "settled solid fraction") continue;  // of a bed, whatever the length
          EXPECT_GE(error.error, before[error.quantity]) << powder.name << error.quantity << share;
          before[error.quantity] = error.error;
        }
      EXPECT_FALSE(before.empty());
      if (lengths.cavity > 0) {
        EXPECT_EQ(before.size(), 3U);
        EXPECT_EQ(expected_errors(powder, 0.494, lengths).size(), 3U);
      }
    }
}

TEST(ExpectedError, OfAnotherPowderIsTheLargestOfAll) {
  PowderSpec known = powder_preset("Distaloy AE"), other = known;
  other.name = "my powder";
  const auto own = expected_errors(known, 1.5e-3, {6e-3}), any = expected_errors(other, 1.5e-3, {6e-3});
  ASSERT_EQ(own.size(), any.size());
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_GE(any[k].error, own[k].error);
  EXPECT_NE(any.front().source.find("another powder"), std::string::npos);
}

TEST(ExpectedError, OfAPresetWithOtherParametersIsThatOfAnotherPowder) {
  PowderSpec changed = powder_preset("Distaloy AE"), bed = powder_preset("ASC100.29 D2");
  changed.friction = 0.3;
  const auto errors = expected_errors(changed, 1.5e-3, {6e-3});
  ASSERT_FALSE(errors.empty());
  for (const auto& error : errors) EXPECT_NE(error.source.find("another powder"), std::string::npos);
  bed.work_of_adhesion = 0;
  EXPECT_TRUE(expected_errors(bed, bed.grain_diameter, {}).empty()) << "its bed was not published";
}

TEST(ExpectedError, OfAPublishedBedIsToldBesides) {
  PowderSpec powder = powder_preset("ASC100.29 D2");
  powder.grain_diameter = 4 * 6 * 7.84e-5;
  const auto none = expected_errors(powder, powder.grain_diameter, {});
  ASSERT_EQ(none.size(), 1U);
  EXPECT_NEAR(none[0].error, (0.3313 - 0.32) / 0.32, 1e-12);
  EXPECT_EQ(largest(none), &none[0]);
  EXPECT_TRUE(error_of(expected_errors(powder, powder.grain_diameter, {0.02}), "settled solid fraction"));
  EXPECT_FALSE(error_of(expected_errors(powder, powder.grain_diameter, {5e-3}), "settled solid fraction"))
      << "beyond a third of the width";
  EXPECT_EQ(expected_errors(powder, 0.5 * powder.grain_diameter, {}).size(), 1U);  // finer ones settle alike
  EXPECT_TRUE(expected_errors(powder, 1.2 * powder.grain_diameter, {}).empty());
  EXPECT_EQ(largest({}), nullptr);
}

/// The runs of one scene, powder and figure in the table of scenes without a cavity.
std::vector<Run> open_runs_of(const GrainSizeTrend& trend) {
  std::ifstream file(std::string(DIEFILL_SOURCE_DIR) + "/process/plan/open_scene_errors.csv");
  std::vector<Run> runs;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (cells.at(0).find("/" + std::string(trend.scene) + ".toml") == std::string::npos ||
        cells.at(1) != trend.powder || cells.at(5) != trend.figure)
      continue;
    runs.push_back({std::stod(cells.at(3)), std::stod(cells.at(6)), 0});
  }
  return runs;
}

TEST(ExpectedError, TrendsOfScenesWithoutACavityAreThoseOfTheirTable) {
  ASSERT_FALSE(open_scene_trends().empty());
  for (const GrainSizeTrend& trend : open_scene_trends()) {
    const auto runs = open_runs_of(trend);
    ASSERT_EQ(runs.size(), static_cast<std::size_t>(trend.runs))
        << trend.scene << trend.powder << trend.figure;
    const Line line = line_through(runs, &Run::value);
    EXPECT_NEAR(trend.slope, line.slope / line.limit, 1e-4) << trend.scene << trend.powder << trend.figure;
    EXPECT_NEAR(trend.scatter, line.scatter / line.limit, 1e-4) << trend.scene << trend.powder;
    EXPECT_NEAR(trend.slope_error, line.slope_error / line.limit, 1e-4) << trend.scene << trend.powder;
  }
}

TEST(ExpectedError, WithoutACavityIsThatOfTheOpeningOrOfTheBed) {
  const PowderSpec powder = powder_preset("Distaloy AE");
  const auto slit = expected_errors(powder, 1e-3, {0, 10e-3, 20e-3, false});
  ASSERT_EQ(slit.size(), 1U);
  EXPECT_EQ(slit[0].quantity, "mass through the opening");
  const auto bed = expected_errors(powder, 1e-3, {0, 0, 20e-3, false});
  ASSERT_EQ(bed.size(), 1U);
  EXPECT_EQ(bed[0].quantity, "bulk solid fraction");
  EXPECT_TRUE(expected_errors(powder, 9e-3, {0, 10e-3, 0, false}).empty()) << "coarser than was run";
}

TEST(ExpectedError, IsSaidWithItsScatterWhereThatIsKnown) {
  EXPECT_EQ(text_of_errors({{"mass", 0.031, 0.012, ""}, {"bed", 0.04, 0, ""}}),
            "mass 3.1 % (scatter 1.2 %), bed 4 %");
  EXPECT_EQ(
      text_of_errors({{"mass", 0.031, 0.012, "", 0.33}, {"bed", 0.04, 0, "", 0.42}}),
      "mass 3.1 % (scatter 1.2 %, extrapolated beyond d/b = 0.33), bed 4 % (extrapolated beyond d/b = 0.42)");
  EXPECT_EQ(text_of_errors({}), "");
}

}  // namespace
}  // namespace diefill::process::plan
