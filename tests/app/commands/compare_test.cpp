// Variants of a scene run and compared through the real program.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/app/commands/variants.h"

namespace diefill::app {
namespace {

/// The entry of `variants` in a measure.
nlohmann::json value_in(const nlohmann::json& comparison, const std::string& key,
                        const std::string& variant) {
  for (const auto& measure : comparison.at("measures"))
    if (measure.at("key") == key)
      for (const auto& value : measure.at("variants"))
        if (value.at("variant") == variant) return value;
  return {};
}

TEST(Compare, RunsAllVariantsAndSeedsAndSaysWhatDiffers) {
  const SmallDie die;
  add_variants(die);
  const std::string staying = "stays beside the pocket, where the powder has been poured, for 1 ms";
  die.exchange("name = \"stays\"", "name = \"" + staying + '"');
  const Outcome outcome = run_program(compare_arguments(die, {"--seeds", "2"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto comparison = comparison_of(die.out());
  EXPECT_EQ(comparison.at("title"), "Small die, one passage");
  EXPECT_EQ(comparison.at("reference"), "quick");
  ASSERT_EQ(comparison.at("runs").size(), 4U);
  double sum = 0;
  for (const std::string seed : {"1", "2"}) {
    const auto report = report_in(die.out() / "quick" / ("seed-" + seed));
    EXPECT_EQ(report.at("title"), "Small die, one passage: quick");
    EXPECT_EQ(report.at("seed").dump(), seed);
    EXPECT_TRUE(report.contains("solid_fraction_top_minus_bottom"));
    EXPECT_TRUE(report.contains("solid_fraction_along_travel_1"));
    sum += report.at("filled_mass_kg").get<double>();
  }
  const auto quick = value_in(comparison, "filled_mass_kg", "quick");
  EXPECT_NEAR(quick.at("mean").get<double>(), sum / 2, 1e-12);  // kg
  EXPECT_EQ(quick.at("seeds"), 2);
  EXPECT_EQ(quick.at("verdict"), "reference");
  // The shoe that stays beside the pocket fills nothing.
  const auto stays = value_in(comparison, "filled_mass_kg", staying);
  EXPECT_EQ(stays.at("mean"), 0);
  EXPECT_NEAR(stays.at("difference").get<double>(), -sum / 2, 1e-12);
  EXPECT_NEAR(value_in(comparison, "cycle_time_s", staying).at("mean").get<double>(), 1e-3, 1e-12);

  EXPECT_NE(outcome.out.find("difference from \"quick\""), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("  " + staying + ' '), std::string::npos) << outcome.out;  // whole
  EXPECT_NE(outcome.out.find("filled mass of model powder, g\n"), std::string::npos) << outcome.out;
  EXPECT_EQ(contents(die.out() / "comparison.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
  const std::string table = contents(die.out() / "comparison.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "variant,measure,unit,mean,scatter,seeds,difference,interval_95,verdict");
}

TEST(Compare, KeepsWhatStandsAndRunsAgainWhatHasChanged) {
  const SmallDie die;
  add_variants(die);
  ASSERT_EQ(run_program(compare_arguments(die)).exit_code, 0);
  const auto before = comparison_of(die.out());
  EXPECT_EQ(value_in(before, "filled_mass_kg", "stays").at("verdict"), "scatter unknown");
  const auto quick = report_in(die.out() / "quick/seed-1");

  const Outcome again = run_program(compare_arguments(die));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("2 of 2 runs are already done"), std::string::npos) << again.err;
  EXPECT_EQ(comparison_of(die.out()), before);

  die.exchange("duration = \"1 ms\"", "duration = \"2 ms\"");
  const Outcome changed = run_program(compare_arguments(die));
  EXPECT_NE(changed.err.find("1 of 2 runs are already done"), std::string::npos) << changed.err;
  EXPECT_NEAR(value_in(comparison_of(die.out()), "cycle_time_s", "stays").at("mean").get<double>(), 2e-3,
              1e-12);
  EXPECT_EQ(report_in(die.out() / "quick/seed-1"), quick);  // wall-clock times and all
}

TEST(Compare, RecordsARunThatLeavesTheValidRangeAndGoesOn) {
  const SmallDie die;
  add_variants(die,
               "\n[[variant]]\nname = \"too soft\"\npowder.reduced_modulus = \"1e4 Pa\"\npour.fill_height = "
               "\"9 mm\"\n");
  const Outcome outcome = run_program(compare_arguments(die));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("\"too soft\", seed 1: failed: "), std::string::npos) << outcome.out;
  const auto comparison = comparison_of(die.out());
  const auto& failed = comparison.at("runs").at(2);
  EXPECT_EQ(failed.at("state"), "failed");
  EXPECT_EQ(failed.at("exit_code"), 3);
  EXPECT_NE(failed.at("reason").get<std::string>().find("overlap"), std::string::npos);
  EXPECT_EQ(value_in(comparison, "filled_mass_kg", "too soft").at("verdict"), "no value");
  EXPECT_EQ(value_in(comparison, "filled_mass_kg", "quick").at("seeds"), 1);
  // It would fail again in the same way: it is not tried a second time, and still told of.
  EXPECT_EQ(run_program(compare_arguments(die)).exit_code, 3);
}

TEST(Compare, ARunWhoseTimeIsOverIsNoResultYet) {
  const SmallDie die;
  die.exchange("[numerics]", "[numerics]\nmax_time = \"5 ms\"");
  const Outcome outcome = run_program(compare_arguments(die));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("failed: the scene had not ended after numerics.max_time"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(comparison_of(die.out()).at("runs").at(0).at("exit_code"), 4);
}

TEST(Compare, DrawsItsRunsUnlessToldNotTo) {
  const SmallDie die;
  die.exchange_passage("[[step]]\nkind = \"wait\"\nduration = \"1 ms\"\n");
  const auto drawn_by = [&](const std::string& name, std::vector<std::string> more) {
    const auto out = die.folder() / name;
    more.insert(more.begin(), {"compare", die.scene().string(), "--out", out.string(), "--quiet"});
    const Outcome outcome = run_program(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto run = out / comparison_of(out).at("runs").at(0).at("folder").get<std::string>();
    EXPECT_TRUE(std::filesystem::exists(run / "results.h5"));
    return std::filesystem::exists(run / "snapshot.png");
  };
  EXPECT_TRUE(drawn_by("drawn", {}));
  EXPECT_FALSE(drawn_by("not drawn", {"--no-pictures"}));
  const Outcome collected =
      run_program({"compare", "--collect", (die.folder() / "drawn").string(), "--no-pictures"});
  EXPECT_EQ(collected.exit_code, 2);
  EXPECT_EQ(collected.complaints(), 1U) << collected.err;
}

TEST(Compare, ChecksEveryVariantBeforeAnythingRuns) {
  const SmallDie die;
  add_variants(die, "\n[[variant]]\nname = \"wrong\"\nstep.1.velocty = \"1 m/s\"\n");
  const Outcome outcome = run_program(compare_arguments(die));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("did you mean \"velocity\"? (in variant \"wrong\")"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out()));
  const Outcome nothing = run_program({"compare"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.complaints(), 1U) << nothing.err;
  const Outcome no_jobs = run_program({"compare", "--collect", die.folder().string()});
  EXPECT_EQ(no_jobs.exit_code, 2);
  EXPECT_NE(no_jobs.err.find("jobs.json"), std::string::npos) << no_jobs.err;
}

TEST(Compare, GoesOnAfterCtrlCAndAfterAKillAndEndsAlike) {
  const SmallDie die, unbroken;
  for (const SmallDie* each : {&die, &unbroken}) add_variants(*each);
  ASSERT_EQ(run_program(compare_arguments(unbroken)).exit_code, 0);
  for (const int signal : {SIGINT, SIGKILL}) {
    Program program(compare_arguments(die));
    while (program.running() && !std::filesystem::exists(die.out() / "quick/seed-1/checkpoint.bin"))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(signal);
    const Outcome outcome = program.wait();
    if (signal == SIGINT) {
      EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
      EXPECT_NE(outcome.err.find("run the same command again to continue"), std::string::npos) << outcome.err;
      // Where Ctrl-C came while it was drawing already, it has finished instead.
      EXPECT_TRUE(std::filesystem::exists(die.out() / "quick/seed-1/checkpoint.bin") ||
                  std::filesystem::exists(die.out() / "quick/seed-1/report.json"));
    }
  }
  const Outcome last = run_program(compare_arguments(die));
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(contents(die.out() / "comparison.json"), contents(unbroken.out() / "comparison.json"));
}

TEST(Compare, ComputesACommonBeginningOnceAndEndsAsIfEachHadRunAlone) {
  const SmallDie die;
  const std::string shaken = R"(
kind = "vibration"
tool = "die"
axis = "y"
amplitude = "0.3 mm"
frequency = "100 Hz"
duration = "60 ms"
)",
                    variants = R"(
[[variant]]
name = "fast"
[[variant]]
name = "faster"
step.2.frequency = "150 Hz"
[[variant]]
name = "slow shoe"
step.1.velocity = "0.05 m/s"
[[variant]]
name = "shaken twice"
[[variant.step]]
kind = "passage"
tool = "shoe"
direction = "-x"
velocity = "0.1 m/s"
)" + ("[[variant.step]]" + shaken + "[[variant.step]]" + shaken) +
                               R"(
[[variant]]
name = "watched"
[[variant.snapshot]]
name = "poured"
)";
  die.exchange("[numerics]", "[[step]]" + shaken + "\n[numerics]");
  die.write("scene.toml", contents(die.scene()) + variants);
  const Outcome compared =
      run_program({"compare", die.scene().string(), "--out", die.out().string(), "--no-pictures"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "beginnings"));

  std::vector<double> taken_over;  // s
  for (const std::string folder : {"fast", "faster", "slow_shoe", "shaken_twice", "watched"}) {
    const auto there = die.out() / folder / "seed-1", alone = die.folder() / folder;
    const Outcome run =
        run_program({"run", (there / "scene.toml").string(), "--out", alone.string(), "--no-pictures"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const char* key : {"state_hash", "steps", "simulated_s", "filled_mass_kg", "energy_balance_error"})
      EXPECT_EQ(report_in(there).at(key), report_in(alone).at(key)) << folder << ' ' << key;
    const std::string log = contents(there / "run.log"), words = "the first ";
    const std::size_t place = log.find(words);
    taken_over.push_back(place == std::string::npos ? 0 : std::stod(log.substr(place + words.size())));
  }
  const Outcome planned =
      run_program({"plan", die.scene().string(), "--variants", "--no-benchmark", "--json"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const auto predicted = nlohmann::json::parse(planned.out).at("variants");
  const auto shared = [&](std::size_t k) { return predicted.at(k).at("shared_s").get<double>(); };
  EXPECT_EQ(shared(0), 0);
  EXPECT_GT(shared(2), 0);
  // How long the poured powder takes to settle is not known without a pilot.
  for (const std::size_t k : {1, 3, 4})
    EXPECT_NEAR(shared(k) - shared(2), taken_over[k] - taken_over[2], 0.002) << k;
  EXPECT_EQ(taken_over[0], 0);
  EXPECT_GT(taken_over[2], 0) << "the settling in the shoe is common to all";
  EXPECT_GT(taken_over[1], taken_over[2]) << "the passage is common to two";
  EXPECT_GT(taken_over[3], taken_over[1]) << "what a scene of more steps does is common but for the last";
  EXPECT_EQ(taken_over[4], taken_over[2]) << "what is to be recorded must still be to come";
  EXPECT_EQ(report_in(die.out() / "watched/seed-1/snapshots/poured").at("state_hash"),
            report_in(die.folder() / "watched/snapshots/poured").at("state_hash"));
}

/// The line of a job's scene that gives `key`.
std::string line_with(const std::string& key, const std::filesystem::path& scene) {
  const std::string text = contents(scene);
  const std::size_t start = text.find('\n' + key);
  return start == std::string::npos ? "" : text.substr(start + 1, text.find('\n', start + 1) - start - 1);
}

TEST(Compare, GivesAllVariantsTheFinestGrainsThatASettingChoosesForAny) {
  const SmallDie die;
  const auto export_to = [&](const std::string& folder) {
    const Outcome outcome = run_program({"compare", die.scene().string(), "--setting", "working",
                                         "--export-jobs", (die.folder() / folder).string()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome;
  };
  add_variants(die);
  const Outcome first = export_to("wide");
  EXPECT_NE(first.err.find("from \"quick\" on, setting working:"), std::string::npos) << first.err;
  EXPECT_EQ(first.err.find("from \"stays\""), std::string::npos) << "said once where it is the same";
  const auto chosen = line_with("grain_diameter", die.folder() / "wide/quick/seed-1/scene.toml");
  EXPECT_EQ(chosen, "grain_diameter = '1.2 mm'") << "four times the calibrated size";

  die.write("scene.toml", contents(die.scene()) + R"(
[[variant]]
name = "narrow box"
pour.to = ["5.5 mm", "1.5 mm", "9 mm"]
)");
  export_to("narrow");
  for (const std::string folder : {"quick", "stays", "narrow_box"}) {
    const auto scene = die.folder() / "narrow" / folder / "seed-1/scene.toml";
    EXPECT_EQ(line_with("grain_diameter", scene), "grain_diameter = '1 mm'") << folder;  // a quarter of 4 mm
    EXPECT_EQ(contents(scene).rfind("# Numbers chosen by: setting working\n", 0), 0U) << contents(scene);
  }
  const Outcome unknown = run_program({"compare", die.scene().string(), "--setting", "worknig"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean \"working\"?"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace diefill::app
