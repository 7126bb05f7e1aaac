// Estimates of sample scenes against formulas on paper.
#include "process/estimate/estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/estimate/discharge/filling.h"
#include "process/estimate/openings/openings.h"
#include "process/input/scene_error.h"
#include "tests/process/estimate/estimate_scene.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;

TEST(OpeningLayout, OfARingHasItsAreaAndItsWidth) {
  const Scene scene = sample("narrow_ring/fill.toml");
  const Tooling tooling = read_tooling(scene);
  const OpeningLayout layout = find_openings(with_prepared_steps(scene, tooling), tooling);
  ASSERT_EQ(layout.openings.size(), 1U);
  const double outer = 8 * kMm + 4.462 * kMm, area = std::numbers::pi * (outer * outer - 64 * kMm * kMm);
  EXPECT_NEAR(layout.openings[0].area, area, 0.01 * area);
  EXPECT_NEAR(layout.openings[0].width, 4.462 * kMm, 0.03 * 4.462 * kMm);
  EXPECT_TRUE(layout.punches.empty());
}

TEST(OpeningLayout, OfAFallingPunchIsThePartAboveIt) {
  const Scene scene = sample("narrow_ring/strategies/volumetric.toml");
  const Tooling tooling = read_tooling(scene);
  const OpeningLayout layout = find_openings(with_prepared_steps(scene, tooling), tooling);
  ASSERT_EQ(layout.punches.size(), 1U);
  EXPECT_NEAR(layout.punches[0].stroke, 20 * kMm, 0.5 * kMm);
  EXPECT_NEAR(layout.punches[0].speed(), 0.02, 0.002);
  EXPECT_NEAR(layout.punches[0].area, layout.openings[0].area, 0.02 * layout.openings[0].area);
}

// Plates on edge leave slivers beside each other, whose area asks for places without end.
TEST(OpeningLayout, OfSliversBesidePlatesStaysSmall) {
  const Scene scene = sample("laboratory/periodic_box.toml");
  const Tooling tooling = read_tooling(scene);
  EXPECT_LT(find_openings(with_prepared_steps(scene, tooling), tooling).places.size(), 100000U);
}

TEST(Estimate, OfASlitIsTheFormulaOfTheMovingShoe) {
  for (const double width : {6.0, 10.0}) {
    const Scene scene =
        sample(width == 6 ? "slit_plate/discharge_6mm.toml" : "slit_plate/discharge_10mm.toml");
    const Estimate found = estimate(scene, read_tooling(scene));
    ASSERT_EQ(found.openings.size(), 1U);
    EXPECT_FALSE(found.openings[0].is_cavity);
    const double grain = scene.powder.grain_diameter;
    const continuum::SlitFlow slit{3000, continuum::effective_width(width * kMm, grain - 0.4704 * kMm),
                                   *scene.numerics.period[1]};
    const double mass = continuum::mass_of_passage(continuum::kSimulatedDischarge, slit, 32 * kMm, 0.18);
    EXPECT_NEAR(found.openings[0].mass.back(), mass, 0.02 * mass);
    EXPECT_NEAR(found.path.speed, 0.18, 0.002);
    EXPECT_NEAR(found.path.length, 32 * kMm, 0.5 * kMm);
    EXPECT_EQ(found.path.crossings, 1U);
  }
}

TEST(Estimate, OfSeveralCrossingsAddsUpUntilTheCavityIsFull) {
  const Scene scene = sample("wide_ring/strategies/passages.toml");
  const Estimate found = estimate(scene, read_tooling(scene));
  const OpeningEstimate& ring = found.openings.at(0);
  ASSERT_GT(ring.offered.size(), 1U);
  EXPECT_NEAR(ring.offered[1], ring.offered[0], 0.02 * ring.offered[0]);  // back and forth alike
  EXPECT_LE(ring.mass.back(), ring.full_mass * (1 + 1e-9));
  const double height = ring.offered[0] / ring.full_mass * ring.depth;
  const double kept = filled_height({ring.depth, ring.width}, height) / ring.depth * ring.full_mass;
  EXPECT_NEAR(ring.mass[0], kept, 1e-9);
  EXPECT_LT(kept, std::min(ring.offered[0], ring.full_mass));
  EXPECT_LT(ring.least_mass, ring.mass.back());
  EXPECT_GT(ring.most_mass, ring.mass.back());
}

TEST(Estimate, CriticalSpeedIsThatAtWhichTheCavityIsJustFull) {
  Scene scene = sample("narrow_ring/fill.toml");
  const Estimate first = estimate(scene, read_tooling(scene));
  ASSERT_TRUE(first.openings.at(0).speed_once);
  const double critical = *first.openings[0].speed_once;
  std::string text = scene.text;
  const std::string old = "velocity = \"0.2 m/s\"";
  text.replace(text.find(old), old.size(), "velocity = \"" + std::to_string(critical) + " m/s\"");
  scene = parse_scene(text, scene.file);
  const Estimate again = estimate(scene, read_tooling(scene));
  EXPECT_NEAR(again.openings.at(0).share, kFull, 0.03);  // the shoe's ramps differ
  EXPECT_LT(critical, 0.2);
  EXPECT_EQ(*again.openings[0].crossings, 1);
}

TEST(Estimate, MoreOfTheShoeMoreInTheCavityFasterLess) {
  const Scene scene = sample("wide_ring/fill.toml");
  const Tooling tooling = read_tooling(scene);
  const Estimate found = estimate(scene, tooling);
  EstimateOptions slower;
  slower.law = found.law;
  slower.law->numbers.steady *= 0.5;
  slower.law->numbers.initial *= 0.5;
  slower.law->numbers.burst *= 0.5;
  const Estimate less = estimate(scene, tooling, slower);
  EXPECT_NEAR(less.openings.at(0).offered.at(0), 0.5 * found.openings.at(0).offered.at(0),
              1e-6 * found.openings.at(0).offered.at(0));
}

TEST(Estimate, ThePowderOfAFallingPunchFollowsAndAirPulls) {
  const Scene scene = sample("narrow_ring/strategies/volumetric.toml");
  EstimateOptions fine;
  fine.particle_diameter = 3e-5;
  const Estimate found = estimate(scene, read_tooling(scene), fine);
  ASSERT_EQ(found.suctions.size(), 1U);
  EXPECT_LE(found.suctions[0].by_weight, *found.suctions[0].with_air * (1 + 1e-9));
  EXPECT_LE(*found.suctions[0].with_air, found.suctions[0].volume_mass * (1 + 1e-9));
  EXPECT_GT(*found.suctions[0].pull, 0);
}

TEST(Estimate, PiNumbersAreThePublishedOnes) {
  const Scene scene = sample("narrow_ring/fill.toml");
  const Estimate found = estimate(scene, read_tooling(scene));
  const auto value = [&](const std::string& name) {
    for (const auto& number : found.numbers)
      if (number.name == name) return number.value;
    return std::nan("");
  };
  EXPECT_NEAR(value("Pi_2"), 8.6, 0.05);  // Bierwisch 2009, chapter 3
  EXPECT_NEAR(value("Pi_3"), 0.2, 1e-9);
  const double pull_off = 1.5 * std::numbers::pi * 0.005 * 3.92e-5;
  EXPECT_NEAR(value("Bond"), pull_off / (7.63e-8 * 9.81), 0.01 * value("Bond"));
  EXPECT_NEAR(value("Bond of the coarse grains"), value("Bond") / 4, 0.01 * value("Bond"));
}

TEST(Estimate, ReadsALawThatWasFittedAndRefusesOthers) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "fit.json";
  folder.write("fit.json", R"({"law": "5.17", "largest_x": 2.5, "coefficients": {"C_B": {"value": 0.1},
    "C_I": {"value": 0.2}, "C_F": {"value": 0.9}, "beta": {"value": 1.1}}})");
  const PowderDischarge law = read_discharge(file);
  EXPECT_EQ(law.numbers.steady, 0.9);
  EXPECT_EQ(law.longest, 2.5);
  for (const char* text :
       {"", "{}", "[1]", R"({"law": "5.18", "coefficients": {}})",
        R"({"law": "5.17", "coefficients": {"C_B": {"value": 0.1}}})", R"({"law": 3, "coefficients": {}})"}) {
    folder.write("fit.json", text);
    EXPECT_THROW(read_discharge(file), SceneError) << text;
  }
  EXPECT_THROW(read_discharge(folder.path() / "none.json"), SceneError);
}

TEST(Estimate, ALawWithoutAPossibleRangeIsRefusedInOneLine) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "fit.json";
  for (const std::string bound : {"-0.1", "-1e300", "null", "\"far\""}) {
    folder.write("fit.json", R"({"law": "5.17", "largest_x": )" + bound +
                                 R"(, "coefficients": {"C_B": {"value": 0.1}, "C_I": {"value": 0.2},
      "C_F": {"value": 0.9}, "beta": {"value": 1.1}}})");
    try {
      read_discharge(file);
      FAIL() << bound;
    } catch (const SceneError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.find(file.string() + ": found "), 0U) << said;
      EXPECT_NE(said.find("largest_x"), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }
}

TEST(Estimate, RateIsConstantBeyondWhatWasMeasured) {
  const PowderDischarge law = discharge_of({});
  const double at = discharged_share(law, law.longest), more = discharged_share(law, law.longest + 1);
  EXPECT_NEAR(more - at, continuum::rate_share(law.numbers, law.longest), 1e-9);
  EXPECT_NEAR(discharged_share(law, 0.5 * law.longest),
              continuum::discharged_share(law.numbers, 0.5 * law.longest), 1e-12);
  EXPECT_EQ(discharged_share(law, -0.1), 0);
}

}  // namespace
}  // namespace diefill::process::estimate
