// Calibration through the real program: a small planted powder is found again from its filled die.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <thread>

#include "project_paths.h"
#include "tests/app/shared_report.h"
#include "tests/support/scene_text.h"

namespace diefill::app {
namespace {

constexpr double kPlanted = 0.45;  // friction

/// A die with a calibration file that asks for the friction; the measurement is a run with a planted one and
/// another seed.
class Calibrated {
 public:
  Calibrated() {
    die_.exchange("reduced_modulus", "friction = 0.45\nreduced_modulus");
    die_.exchange("seed = 1", "seed = 77");
    measured_ = shared_report(die_).at("filled_mass_kg").get<double>() * 1e6;
    die_.exchange("friction = 0.45", "friction = 0.3");
    die_.write("calibration.toml", text());
  }
  std::string text() const {
    return "title = \"Small powder\"\nseed = 1\n\n[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.05\nto "
           "= 1.2\n\n"
           "[[measurement]]\nname = \"filled die\"\nscene = \"scene.toml\"\nfigure = "
           "\"filled_mass_kg\"\nvalue = \"" +
           std::to_string(measured_) +
           " mg\"\ndeviation = \"20 mg\"\n\n[search]\nseeds = 1\nstart_points = 4\nmost_points = 6\n";
  }
  const SmallDie& die() const { return die_; }
  std::filesystem::path out(const std::string& name = "found") const { return die_.folder() / name; }
  std::vector<std::string> arguments(const std::vector<std::string>& more = {},
                                     const std::string& out_name = "found") const {
    std::vector<std::string> all = {"calibrate", (die_.folder() / "calibration.toml").string(), "--out",
                                    out(out_name).string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

 private:
  SmallDie die_;
  double measured_ = 0;
};

/// Where the results of the whole calibration are, which tests share and leave as they are. To be asked for
/// before other files lie beside those of `calibrated`.
std::filesystem::path results_of(const Calibrated& calibrated) {
  return shared_folder(calibrated.die(), "calibration", [&](const std::filesystem::path& folder) {
    const Outcome outcome =
        run_program({"calibrate", (calibrated.die().folder() / "calibration.toml").string(), "--out",
                     folder.string(), "--pdf"});
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.err + outcome.out);
  });
}

nlohmann::json account_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(contents(folder / "calibration.json"));
}

TEST(Calibrate, FindsAPlantedFrictionAndWritesAPowderThatScenesUse) {
  const Calibrated calibrated;
  const auto results = results_of(calibrated);
  const auto account = account_in(results);
  const auto& friction = account.at("parameters").at(0);
  EXPECT_EQ(friction.at("key"), "powder.friction");
  EXPECT_LE(friction.at("lower_90").get<double>(), kPlanted);
  EXPECT_GE(friction.at("upper_90").get<double>(), kPlanted);
  EXPECT_TRUE(account.at("agrees").get<bool>());
  for (const char* file :
       {"calibration.html", "calibration.pdf", "calibration.csv", "calibration_points.csv"})
    EXPECT_GT(contents(results / file).size(), 100U) << file;
  EXPECT_EQ(contents(results / "calibration.pdf").substr(0, 4), "%PDF");
  // One value for one parameter is met by some powder.
  EXPECT_NE(contents(results / "calibration.html").find("proves nothing: no degree of freedom"),
            std::string::npos);
  const std::string powder = contents(results / "powder.toml");
  for (const char* line : {"scene = \"scene.toml\"\n", "deviation = \"20 mg\"\n", "verdict = \"agrees\"\n"})
    EXPECT_NE(powder.find(line), std::string::npos) << line;

  // The powder in a scene: the run has its friction, and says so where its walls are others.
  const auto& die = calibrated.die();
  std::filesystem::copy_file(results / "powder.toml", die.folder() / "powder.toml");
  die.exchange(
      "preset = \"ASC100.29 A2\"\ngrain_diameter = \"1 mm\"\nfriction = 0.3\nreduced_modulus = \"3 MPa\"\n",
      "file = \"powder.toml\"\nreduced_modulus = \"4 MPa\"\n");
  const Outcome run = die.run({"--no-pictures"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::string warnings;
  const auto report = die.report();
  for (const auto& warning : report.at("warnings")) warnings += warning.get<std::string>() + '\n';
  EXPECT_NE(warnings.find("reduced modulus 4 MPa instead of 3 MPa"), std::string::npos) << warnings;
}

/// A calibration of the small die that is refused before anything runs; `measurement` gives its value.
Outcome refused_calibration(const SmallDie& die, const std::string& measurement,
                            const std::vector<std::string>& more) {
  die.write("calibration.toml",
            "powder = \"powder.toml\"\n[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.05\nto = 1.2\n"
            "[[measurement]]\nname = \"filled die\"\nscene = \"scene.toml\"\nfigure = \"filled_mass_kg\"\n" +
                measurement);
  die.write("powder.toml",
            "[powder]\npreset = \"ASC100.29 A2\"\nreduced_modulus = \"3 MPa\"\n"
            "damping_over_radius = \"3e5 Pa s/m\"\n");
  std::vector<std::string> words = {"calibrate", (die.folder() / "calibration.toml").string()};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

TEST(Calibrate, ADirectoryWhoseInputsItWouldReplaceIsRefused) {
  const SmallDie die;
  std::filesystem::create_directory(die.folder() / "there");
  const std::string mass = "filled mass [mg], deviation [mg]\n60, 3\n";
  die.write("there/calibration.csv", mass);
  const Outcome csv = refused_calibration(die, "file = \"there/calibration.csv\"\n",
                                          {"--out", (die.folder() / "there").string()});
  EXPECT_EQ(csv.exit_code, 2);
  EXPECT_EQ(csv.complaints(), 1U) << csv.err;
  EXPECT_NE(csv.err.find("whose calibration.csv the command reads and would overwrite"), std::string::npos)
      << csv.err;
  EXPECT_EQ(contents(die.folder() / "there/calibration.csv"), mass);
  const Outcome powder = refused_calibration(die, "value = \"60 mg\"\ndeviation = \"3 mg\"\n",
                                             {"--export-jobs", die.folder().string()});
  EXPECT_EQ(powder.exit_code, 2);
  EXPECT_NE(powder.err.find("whose powder.toml the command reads"), std::string::npos) << powder.err;
}

TEST(Calibrate, KilledAtRandomMomentsItGoesOnToTheSameResult) {
  const Calibrated calibrated;
  const auto whole = results_of(calibrated);
  std::vector<std::string> more = {"--quiet"};
  for (const int milliseconds : {1500, 2300, 900}) {
    Program program(calibrated.arguments(more, "killed"));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(milliseconds == 900 ? SIGINT : SIGKILL);
    const Outcome ended = program.wait();
    if (ended.exit_code == 130) {
      EXPECT_NE(ended.err.find("run the same command with --resume to continue"), std::string::npos)
          << ended.err;
    }
    more = {"--quiet", "--resume"};
  }
  const Outcome last = run_program(calibrated.arguments(more, "killed"));
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(contents(calibrated.out("killed") / "powder.toml"), contents(whole / "powder.toml"));
  EXPECT_EQ(account_in(calibrated.out("killed")).at("samples"), account_in(whole).at("samples"));
}

TEST(Calibrate, ADirectoryWithRunsIsContinuedOnlyWhenAsked) {
  const Calibrated calibrated;
  // The budget ends with the first run; nothing was found.
  const Outcome first = run_program(calibrated.arguments({"--budget", "0.0001"}));
  EXPECT_EQ(first.exit_code, 1) << first.err;
  EXPECT_NE(first.out.find("the budget is used\nno powder found: the same command with --resume"),
            std::string::npos)
      << first.out;
  EXPECT_FALSE(std::filesystem::exists(calibrated.out() / "powder.toml"));
  const Outcome second = run_program(calibrated.arguments());
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_EQ(second.complaints(), 1U) << second.err;
  EXPECT_NE(second.err.find("add --resume to continue"), std::string::npos) << second.err;
  const Outcome third = run_program(calibrated.arguments({"--resume", "--budget", "100"}));
  EXPECT_EQ(third.exit_code, 0) << third.err;
}

TEST(Calibrate, AScreeningWithoutEffectsNamesNoSourceOfErrors) {
  const Calibrated calibrated;
  const Outcome outcome = run_program(calibrated.arguments({"--screen", "--budget", "0.0001"}));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.out.find("standard errors from"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("no effects found: the same command with --resume"), std::string::npos)
      << outcome.out;
}

TEST(Calibrate, AValueThatNoPowderReachesIsReported) {
  const Calibrated calibrated;
  calibrated.die().write("calibration.toml",
                         support::exchanged(calibrated.text(), "value = \"", "value = \"9"));
  const Outcome outcome = run_program(calibrated.arguments());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("no parameters in these ranges reach 1 of its 1 values"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("does not agree with the data"), std::string::npos) << outcome.out;
  EXPECT_FALSE(account_in(calibrated.out()).at("agrees").get<bool>());
}

TEST(Calibrate, AScreeningChartsEffectsWithTheirErrors) {
  const Calibrated calibrated;
  calibrated.die().write(
      "calibration.toml",
      support::exchanged(
          support::exchanged(
              calibrated.text(), "[[measurement]]",
              "[[parameter]]\nkey = \"walls.friction\"\nfrom = 0.05\nto = 0.5\n\n[[measurement]]"),
          "seeds = 1\nstart_points = 4", "seeds = 2\nstart_points = 4") +
          "\n[[measurement]]\nname = \"level\"\nscene = \"scene.toml\"\nfigure = \"fill_height_mm\"\nvalue = "
          "\"3 mm\"\n"
          "deviation = \"0.1 mm\"\n");
  const Outcome outcome = run_program(calibrated.arguments({"--screen"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto screening = account_in(calibrated.out()).at("screening");
  EXPECT_EQ(screening.at("runs"), 4);
  const auto& mass = screening.at("quantities").at(0);
  ASSERT_TRUE(mass.at("standard_error").is_number());
  for (const char* effect : {"A", "B", "AB"})
    EXPECT_TRUE(mass.at("effects").at(effect).is_number()) << effect;
  EXPECT_LT(mass.at("effects").at("A").get<double>(), 0);  // more friction, less mass
  EXPECT_GT(contents(calibrated.out() / "screening.html").size(), 1000U);
  EXPECT_EQ(contents(calibrated.out() / "screening.csv").substr(0, 6), "effect");
}

TEST(Calibrate, RunsDoneElsewhereAreCollectedRoundByRound) {
  const Calibrated calibrated;
  const auto here = results_of(calibrated);
  const std::string jobs = calibrated.out("jobs").string();
  const std::string file = (calibrated.die().folder() / "calibration.toml").string();
  const std::string run =
      "cd '" + jobs + "' && DIEFILL='" + DIEFILL_PROGRAM + "' sh run_here.sh 2 > /dev/null 2>&1";
  const Outcome nothing = run_program({"calibrate", file, "--collect", jobs});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_NE(nothing.err.find("found no runs in"), std::string::npos) << nothing.err;
  EXPECT_FALSE(std::filesystem::exists(jobs));
  int rounds = 0;
  for (; rounds < 6; ++rounds) {
    const Outcome exported = run_program({"calibrate", file, "--export-jobs", jobs, "--quiet"});
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    if (exported.out.find("no runs are left to do") != std::string::npos) break;
    if (rounds == 0) {
      const Outcome early = run_program({"calibrate", file, "--collect", jobs, "--quiet"});
      EXPECT_EQ(early.exit_code, 1) << early.err;
      EXPECT_NE(early.out.find("4 runs are not finished"), std::string::npos) << early.out;
    }
    ASSERT_EQ(std::system(run.c_str()), 0);
  }
  EXPECT_GE(rounds, 2);
  EXPECT_LT(rounds, 6);
  const Outcome collected = run_program({"calibrate", file, "--collect", jobs, "--quiet"});
  ASSERT_EQ(collected.exit_code, 0) << collected.err;
  EXPECT_EQ(contents(calibrated.out("jobs") / "powder.toml"), contents(here / "powder.toml"));
}

TEST(Calibrate, ProfilesMapsChecksAndFinerGrainsGoThrough) {
  const Calibrated calibrated;
  const auto& die = calibrated.die();
  die.write("level.csv",
            "distance along the shoe's travel [mm], level [mm], deviation [mm]\n1, 3.2, 0.3\n3, 3.7, 0.3\n");
  die.write("map.csv", "x [mm], y [mm], level [mm], deviation [mm]\n-4, 0, 3.3, 0.5\n-2, 0, 3.5, 0.5\n");
  const auto more = [](const std::string& name, const std::string& kind, const std::string& quantity) {
    return "\n[[measurement]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" + quantity +
           "\nscene = \"scene.toml\"\n";
  };
  die.write("calibration.toml",
            calibrated.text() + more("ruler", "profile", "profile = \"fill level\"") +
                "file = \"level.csv\"\n" + more("photograph", "map", "map = \"fill level\"") +
                "file = \"map.csv\"\nuse = \"check\"\n[check]\ngrain_diameter = \"0.9 mm\"\n");
  const Outcome outcome = run_program(calibrated.arguments({"--quiet"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string finer = "with finer grains (0.9 mm)";
  EXPECT_NE(outcome.out.find("- " + finer), std::string::npos) << outcome.out;
  EXPECT_NE(contents(calibrated.out() / "calibration.html").find(finer), std::string::npos);
  const auto account = account_in(calibrated.out());
  const auto& measurements = account.at("measurements");
  ASSERT_EQ(measurements.size(), 3U);
  EXPECT_EQ(measurements[1].at("data").size(), 2U);
  EXPECT_TRUE(measurements[1].at("data")[0].at("simulated").is_number());
  // Kept for checking: at the best parameters and over the edge of the region, and at finer grains.
  const auto& checked = measurements[2];
  EXPECT_EQ(checked.at("use"), "check");
  for (const auto& datum : checked.at("data"))
    for (const char* key : {"simulated", "lower_90", "upper_90", "simulated_with_finer_grains"})
      EXPECT_TRUE(datum.at(key).is_number()) << key;
  std::map<std::string, int> roles;
  for (const auto& point : account.at("points")) ++roles[point.at("role").get<std::string>()];
  EXPECT_EQ(roles["best"], 1);
  EXPECT_EQ(roles["edge"], 2);
  EXPECT_EQ(roles["finer"], 1);
}

TEST(Calibrate, PowdersOfItsRegionShowWhatTheirUncertaintyDoes) {
  const Calibrated calibrated;
  const auto found = results_of(calibrated);
  const auto& die = calibrated.die();
  const auto samples = [&](const std::string& number) {
    return run_program({"run", die.scene().string(), "--powder-samples", number, "--seeds", "2", "--out",
                        (die.folder() / "spread").string(), "--quiet"});
  };
  const Outcome without = samples("3");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_EQ(without.complaints(), 1U) << without.err;
  EXPECT_NE(without.err.find("no powder.file"), std::string::npos) << without.err;
  std::filesystem::copy_file(found / "powder.toml", die.folder() / "powder.toml");
  die.exchange(
      "preset = \"ASC100.29 A2\"\ngrain_diameter = \"1 mm\"\nfriction = 0.3\nreduced_modulus = \"3 MPa\"\n"
      "damping_over_radius = \"3e5 Pa s/m\"\n",
      "file = \"powder.toml\"\n");
  die.exchange("file = \"powder.toml\"\n", "file = \"powder.toml\"\nfriction = 0.9\n");
  const Outcome own = samples("3");
  EXPECT_EQ(own.exit_code, 2);
  EXPECT_EQ(own.complaints(), 1U) << own.err;
  EXPECT_NE(own.err.find("powder.friction: found 0.9, but --powder-samples draws it"), std::string::npos)
      << own.err;
  die.exchange("friction = 0.9\n", "");
  const Outcome with = samples("3");
  ASSERT_EQ(with.exit_code, 0) << with.err;
  EXPECT_NE(with.out.find(" over seeds"), std::string::npos) << with.out;
  EXPECT_EQ(with.out.find("unknown"), std::string::npos) << with.out;
  const auto spread = nlohmann::json::parse(contents(die.folder() / "spread" / "powder_samples.json"));
  EXPECT_EQ(spread.at("powders").size(), 3U);
  for (const auto& figure : spread.at("figures")) {
    if (figure.at("key") != "filled_mass_kg") continue;
    EXPECT_EQ(figure.at("unit"), "kg");
    EXPECT_EQ(figure.at("of_seeds").size(), 2U);
    EXPECT_EQ(figure.at("of_powders").size(), 3U);
    const double all = figure.at("spread_over_powders"), seeds = figure.at("scatter_over_seeds");
    EXPECT_NEAR(figure.at("effect_of_the_powder").get<double>(),
                std::sqrt(std::max(0.0, all * all - seeds * seeds)), 1e-12);
    // Two seeds and three powders: F exceeds 49.5 by chance in 10 % of cases.
    EXPECT_EQ(figure.at("significant").get<bool>(), all * all > 49.5 * seeds * seeds);
  }
  EXPECT_GT(contents(die.folder() / "spread" / "powder_samples.html").size(), 1000U);
}

}  // namespace
}  // namespace diefill::app
