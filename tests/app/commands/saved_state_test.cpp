// Powder that begins as another run left it: pour.state and pour.state_below.
#include <gtest/gtest.h>

#include "process/results/storage/result_file.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

constexpr const char* kPour =
    "from = [\"-4.95 mm\", \"-1.95 mm\", \"-4 mm\"]\nto = [\"-1.05 mm\", \"1.95 mm\", \"2 "
    "mm\"]\nfill_height = \"2.5 mm\"\nlattice_constant = 1.25";

/// Powder at rest in the pocket, its results in "settled", and a scene that goes on from there with `pour`.
void settle_and_go_on(const SmallDie& die, const std::string& pour) {
  die.pour_into_the_pocket();
  die.exchange_passage("");
  take_shared_results(die);
  std::filesystem::rename(die.out(), die.folder() / "settled");
  die.exchange(kPour, pour);
}

nlohmann::json settled_report(const SmallDie& die) {
  return nlohmann::json::parse(contents(die.folder() / "settled/report.json"));
}

/// The scene ends with exit code 2, one line that holds all of `parts`, and no results.
void expect_refused(const SmallDie& die, const std::vector<std::string>& parts) {
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  for (const auto& part : parts) EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "results.h5"));
}

TEST(SavedState, BeginsWithTheGrainsOfTheOtherRunAtRest) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto before = settled_report(die), after = die.report();
  EXPECT_EQ(after.at("grains"), before.at("grains"));
  const double mass = before.at("filled_mass_kg").get<double>();
  EXPECT_NEAR(after.at("filled_mass_kg").get<double>(), mass, 1e-9 * mass);
  // It has fallen nowhere: rest is seen at once.
  EXPECT_LT(after.at("simulated_s").get<double>(), 0.5 * before.at("simulated_s").get<double>());
}

TEST(SavedState, IsCutAtAHeight) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"\nstate_below = \"-2.2 mm\"");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const auto before = settled_report(die).at("grains").get<int>(),
             after = die.report().at("grains").get<int>();
  EXPECT_GT(after, before / 4);
  EXPECT_LT(after, before);
}

TEST(SavedState, OfAHalfModelGoesOnInAHalfModel) {
  const SmallDie die;
  die.exchange("[numerics]", "[economy]\nmirror = \"y\"\n\n[numerics]");
  settle_and_go_on(die, "state = \"settled\"");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto before = settled_report(die), after = die.report();
  EXPECT_EQ(after.at("grains"), before.at("grains"));
  const double mass = before.at("filled_mass_kg").get<double>();
  EXPECT_NEAR(after.at("filled_mass_kg").get<double>(), mass, 1e-9 * mass);
}

TEST(SavedState, ResumesAsTheUnbrokenRun) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const auto unbroken = die.report();
  std::filesystem::remove_all(die.out());
  die.exchange("checkpoint_interval = \"1 s\"\n", "checkpoint_interval = \"1 s\"\nmax_time = \"1 ms\"\n");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 4);
  die.exchange("max_time = \"1 ms\"\n", "max_time = \"5 s\"\n");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures", "--resume"}).exit_code, 0);
  EXPECT_EQ(die.report().at("state_hash"), unbroken.at("state_hash"));
}

TEST(SavedState, OfAnotherFileIsAnotherComputation) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  die.exchange("checkpoint_interval = \"1 s\"\n", "checkpoint_interval = \"1 s\"\nmax_time = \"1 ms\"\n");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 4);
  // The same name, another content.
  std::filesystem::rename(die.folder() / "settled", die.folder() / "first");
  die.exchange("state = \"settled\"", kPour);
  die.exchange("seed = 1", "seed = 2");
  const std::string elsewhere = (die.folder() / "settled").string();
  die.exchange("max_time = \"1 ms\"\n", "");
  ASSERT_EQ(
      run_program({"run", die.scene().string(), "--out", elsewhere, "--quiet", "--no-pictures"}).exit_code,
      0);
  die.exchange(kPour, "state = \"settled\"");
  die.exchange("seed = 2", "seed = 1");
  die.exchange("checkpoint_interval = \"1 s\"\n", "checkpoint_interval = \"1 s\"\nmax_time = \"5 s\"\n");
  const Outcome outcome = die.run({"--quiet", "--no-pictures", "--resume"});
  EXPECT_NE(outcome.exit_code, 0) << "went on from a checkpoint of other powder";
}

TEST(SavedState, OfOtherContentsIsAnotherRunOfAComparison) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  die.write("scene.toml", contents(die.scene()) + "\n[[variant]]\nname = \"alone\"\n");
  const auto compared = die.folder() / "compared";
  const auto compare = [&] {
    const Outcome outcome =
        run_program({"compare", die.scene().string(), "--out", compared.string(), "--no-pictures"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  compare();
  const std::string same = compare();
  EXPECT_EQ(same.find("renamed"), std::string::npos) << same;
  auto other = results::read_results(die.folder() / "settled");
  other.title = "another run";
  results::write_results(die.folder() / "settled", other);
  const std::string changed = compare();
  EXPECT_NE(changed.find("from another pour.state were renamed: alone/seed-1"), std::string::npos) << changed;
  EXPECT_TRUE(std::filesystem::exists(compared / "alone/seed-1-previous-1/results.h5"));
  EXPECT_TRUE(std::filesystem::exists(compared / "alone/seed-1/results.h5"));
}

TEST(SavedState, ThatTheRunWouldMoveAwayIsRefusedAndStays) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  const std::string before = contents(die.folder() / "settled/results.h5"),
                    settled = (die.folder() / "settled").string();
  const Outcome outcome = run_program({"run", die.scene().string(), "--out", settled, "--quiet"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  for (const char* part : {"scene.toml:", "pour.state: found", "choose another directory with --out"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_TRUE(contents(die.folder() / "settled/results.h5") == before);
  EXPECT_FALSE(std::filesystem::exists(die.folder() / "settled/previous-1"));
}

TEST(SavedState, WithoutVelocitiesIsRefused) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  auto result = results::read_results(die.folder() / "settled");
  result.powder.velocity.clear();
  results::write_results(die.folder() / "settled", result);
  expect_refused(die, {"scene.toml:", "pour.state", "no /powder/velocity"});
}

TEST(SavedState, ThatIsMissingIsNamed) {
  const SmallDie die;
  die.pour_into_the_pocket();
  die.exchange(kPour, "state = \"nowhere\"");
  expect_refused(die, {"scene.toml:", "pour.state", "\"nowhere\"", "not the directory of a run's results"});
}

TEST(SavedState, TakesNoOtherPowder) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.9 mm\"");
  expect_refused(die, {"pour.state", "that run had grains of 1 mm", "this scene has grains of 0.9 mm",
                       "give the same [powder] and grain_diameter"});
}

TEST(SavedState, LeavesNoGrainInATool) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"");
  die.add_tool("punch", "punch", cad::prism(cad::rectangle(-4.8, -1.2, -1.8, 1.8), -2.5, 4),
               "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  expect_refused(die, {"pour.state", "tool \"punch\" reaches", "into a grain at", "state_below"});
}

TEST(SavedState, CutBelowAllGrainsIsRefused) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"\nstate_below = \"-4 mm\"");
  expect_refused(die, {"scene.toml:", "pour.state_below", "no grain of that run is left"});
}

TEST(SavedState, GoesWithNoKeyOfTheLattice) {
  const SmallDie die;
  settle_and_go_on(die, "state = \"settled\"\nfill_height = \"2 mm\"");
  expect_refused(die, {"pour.fill_height", "pour.state gives all grains; remove the key"});
}

TEST(SavedState, CutAloneIsRefused) {
  const SmallDie die;
  die.pour_into_the_pocket();
  die.exchange(kPour, std::string(kPour) + "\nstate_below = \"1 mm\"");
  expect_refused(die, {"pour.state_below", "it cuts the powder of pour.state; give state"});
}

}  // namespace
}  // namespace diefill::app
