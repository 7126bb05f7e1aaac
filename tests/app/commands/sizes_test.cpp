// Powder of several sizes through the real program: run, threads, restart, maps, reports.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

constexpr const char* kSizes =
    "[powder.sizes]\ndistribution = \"classes\"\nclasses = [{ diameter = \"0.8 mm\", share = 0.3 }, { "
    "diameter = \"1 mm\", share = 0.4 }, { diameter = \"1.25 mm\", share = 0.3 }]\n\n[walls]";

/// The small die with grains of three sizes.
void give_sizes(const SmallDie& die) {
  std::string text = contents(die.scene());
  const std::size_t from = text.find("grain_diameter");
  text.erase(from, text.find('\n', from) + 1 - from);
  die.write("scene.toml", text);
  die.exchange("[walls]", kSizes);
}

std::vector<std::string> with_threads(const SmallDie& die, const std::string& threads) {
  auto arguments = die.run_arguments({"--quiet", "--no-pictures"});
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k)
    if (arguments[k] == "--threads") arguments[k + 1] = threads;
  return arguments;
}

// Series over time of a powder that a last step removes.
TEST(Sizes, ResultsCanBeReadWhereAllGrainsAreGoneInTheEnd) {
  const SmallDie die;
  give_sizes(die);
  const std::string velocity = "velocity = \"0.1 m/s\"\n";
  die.exchange(velocity, velocity + "\n[[step]]\nkind = \"clear\"\nabove = \"-1 m\"\n");
  die.exchange("[measure]", "[measure]\nsnapshot_interval = \"10 ms\"");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = results::read_results(die.out());
  EXPECT_TRUE(result.powder.position.empty());
  ASSERT_FALSE(result.instants.empty());
  EXPECT_EQ(result.instants.front().kind.size(), result.instants.front().position.size());
  EXPECT_EQ(result.powder.kinds.diameter.size(), 3U);
}

TEST(Sizes, RunMeasureAndDraw) {
  const SmallDie die;
  give_sizes(die);
  const Outcome checked = die.check();
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_NE(checked.out.find("sizes: 3 classes from 0.8 mm to 1.25 mm, shares by mass"), std::string::npos)
      << checked.out;
  const Outcome outcome = run_program(with_threads(die, "1"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  for (const char* figure : {"mixing_index_height", "mixing_index_travel", "mean_grain_diameter_filled_mm",
                             "mean_grain_diameter_top_minus_bottom_mm"})
    EXPECT_TRUE(report.contains(figure)) << figure;
  EXPECT_GT(report.at("filled_mass_kg").get<double>(), 0);
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.01);

  const auto result = results::read_results(die.out());
  ASSERT_EQ(result.powder.kinds.size(), 3U);
  ASSERT_EQ(result.powder.kind.size(), result.powder.position.size());
  double filled = 0;
  for (std::size_t k = 0; k < result.powder.kind.size(); ++k)
    if (result.solid_fraction.in_cavity[k] != 0) filled += result.powder.kinds.mass[result.powder.kind[k]];
  EXPECT_NEAR(report.at("filled_mass_kg").get<double>(), filled, 1e-9 * filled);

  for (const char* picture : {"size-section", "view"}) {
    std::vector<std::string> arguments = {
        "map", die.out().string(), "--picture", picture, "--out", (die.folder() / "maps").string()};
    if (arguments[3] == "view") arguments.insert(arguments.end(), {"--colour-by", "diameter"});
    const Outcome drawn = run_program(arguments);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  }
  EXPECT_EQ(SmallDie::files_in(die.folder() / "maps"),
            (std::vector<std::string>{"size_section.png", "view.png"}));
  const Outcome reported = run_program({"info", die.out().string()});
  EXPECT_EQ(reported.exit_code, 0) << reported.err;

  SmallDie other;
  give_sizes(other);
  const Outcome two = run_program(with_threads(other, "2"));
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(other.report().at("state_hash"), report.at("state_hash"));
}

TEST(Sizes, EndAsTheUnbrokenRunAfterAKill) {
  const SmallDie die, other;
  give_sizes(die);
  give_sizes(other);
  ASSERT_EQ(run_program(with_threads(other, "1")).exit_code, 0);
  {
    Program program(with_threads(die, "1"));
    while (program.running() && !std::filesystem::exists(die.out() / "checkpoint.bin"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    program.send(SIGKILL);
    ASSERT_EQ(program.wait().signal, SIGKILL);
  }
  auto again = with_threads(die, "2");
  again.push_back("--resume");
  ASSERT_EQ(run_program(again).exit_code, 0);
  for (const char* key : {"state_hash", "filled_mass_kg", "steps", "grains_left", "mass_left_kg"})
    EXPECT_EQ(die.report().at(key), other.report().at(key)) << key;
}

TEST(Sizes, AreEnlargedTogetherByASetting) {
  const SmallDie die;
  give_sizes(die);
  const Outcome outcome = run_program({"run", die.scene().string(), "--setting", "quick", "--out",
                                       die.out().string(), "--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto kinds = results::read_results(die.out()).powder.kinds;
  ASSERT_EQ(kinds.size(), 3U);
  EXPECT_NEAR(kinds.diameter[1] / kinds.diameter[0], 1.25, 1e-9);
  EXPECT_NE(kinds.diameter[0], 0.8e-3) << "the setting has chosen";
  EXPECT_EQ(run_program({"plan", die.scene().string(), "--no-benchmark"}).exit_code, 0);
}

}  // namespace
}  // namespace diefill::app
