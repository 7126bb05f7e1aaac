// diefill bench: figures of a bed that it makes or reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/commands/bench/more_threads.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// Columns of four spheres that lie on each other about as deep as their weight presses them, as the rows of
/// a bed file.
std::string columns_of_spheres() {
  std::ostringstream rows;
  rows.precision(12);
  rows << "id,x,y,z,vx,vy,vz,wx,wy,wz\n";
  int id = 0;
  for (int layer = 0; layer < 4; ++layer)
    for (int k = 0; k < 38; ++k)
      for (int i = 0; i < 38; ++i)
        rows << ++id << ',' << (i + 0.5) * 0.012 / 38 << ',' << (k + 0.5) * 0.012 / 38 << ','
             << 1.5e-4 + layer * (3e-4 - 5e-8) - 5e-8 << ",0,0,0,0,0,0\n";
  return rows.str();
}

nlohmann::json bench(const SmallDie& die, const std::string& threads) {
  const Outcome outcome = run_program({"bench", "spheres", "--state", (die.folder() / "bed.csv").string(),
                                       "--steps", "20", "--threads", threads, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(Bench, ReadsABedAndCountsItsContacts) {
  SmallDie die;
  die.write("bed.csv", columns_of_spheres());
  const auto figures = bench(die, "1");
  EXPECT_EQ(figures["spheres"], 4 * 38 * 38);
  EXPECT_EQ(figures["steps"], 20);
  EXPECT_GT(figures["sphere_steps_per_second"], 0);
  // Columns of four touch along z only: three contacts a column.
  EXPECT_NEAR(figures["contacts_per_sphere"].get<double>(), 2 * 3 / 4.0, 0.01);
  EXPECT_GT(figures["bytes_moved_per_sphere_step"], 100);
  EXPECT_EQ(figures["nanoseconds_per_sphere_step"].size(), 4U);
  EXPECT_EQ(bench(die, "2")["state_hash"], figures["state_hash"]);
}

TEST(Bench, RacesThreadsAgainstCopies) {
  SmallDie die;
  die.write("bed.csv", columns_of_spheres());
  const std::vector<std::string> words = {
      "bench",   "spheres", "--state",         (die.folder() / "bed.csv").string(),
      "--steps", "20",      "--against-copies"};
  auto alone = words;
  alone.insert(alone.end(), {"--threads", "1", "--repeats", "2", "--json"});
  const Outcome outcome = run_program(alone);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto benchmark = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(benchmark["repeats"].size(), 2U);
  for (const auto& repeat : benchmark["repeats"])
    EXPECT_DOUBLE_EQ(repeat["ratio"].get<double>(),
                     repeat["threads"].get<double>() / repeat["copies"].get<double>());
  EXPECT_EQ(benchmark["predicted"][1]["threads"], 64);

  auto too_many = words;
  too_many.insert(too_many.end(), {"--threads", "1024"});
  const Outcome refused = run_program(too_many);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--threads 1024 needs as many processors, found: "), std::string::npos)
      << refused.err;
}

// A run that ends too early leaves a checkpoint; timing goes on from it and leaves it as it is.
TEST(Bench, TimesASceneUnderWay) {
  SmallDie die;
  ASSERT_EQ(die.run({"--no-pictures", "--set", "numerics.max_time = \"0.02 s\""}).exit_code, 4);
  const auto files = SmallDie::files_in(die.out());
  const auto timed = [&](const std::string& threads) {
    const Outcome outcome = run_program({"bench", die.scene().string(), "--state", die.out().string(),
                                         "--steps", "40", "--threads", threads, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  };
  const auto one = timed("1"), two = timed("2");
  EXPECT_EQ(one["steps"], 40);
  EXPECT_GT(one["spheres"], 0);
  EXPECT_GT(one["from_s"].get<double>(), 0.02);
  EXPECT_GT(one["to_s"].get<double>(), one["from_s"].get<double>());
  EXPECT_EQ(one["state_hash"], two["state_hash"]);
  EXPECT_EQ(SmallDie::files_in(die.out()), files);
}

// Clumps of seven spheres beside single spheres.
TEST(Bench, CountsTheSpheresOfEachGrainWhereShapesAreMixed) {
  SmallDie die;
  die.exchange("preset = \"ASC100.29 A2\"", "preset = \"ASC100.29 D2\"");
  die.exchange("[[tool]]\nname = \"die\"",
               "[[other_powder]]\nname = \"copper\"\nshare = 0.3\nmodel = \"A\"\nsphere_radius = \"0.1 "
               "mm\"\ngrain_mass = \"2.6e-8 kg\"\ngrain_diameter = \"0.9 mm\"\nreduced_modulus = \"3 "
               "MPa\"\nfriction = 0.2\n\n[[tool]]\nname = \"die\"");
  ASSERT_EQ(die.run({"--no-pictures", "--quiet", "--set", "numerics.max_time = \"0.002 s\""}).exit_code, 4);
  const Outcome outcome = run_program({"bench", die.scene().string(), "--state", die.out().string(),
                                       "--steps", "5", "--threads", "1", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["spheres"], die.report().at("spheres"));
}

TEST(Bench, ScenesNeedACheckpointAndNoWordsOfBeds) {
  SmallDie die;
  const auto refusal = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"bench", die.scene().string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(refusal({}).find("--state must name the directory of a stopped run"), std::string::npos);
  EXPECT_NE(refusal({"--law", "jkr"}).find("are for beds"), std::string::npos);
  EXPECT_NE(refusal({"--state", die.folder().string()}).find("no checkpoint of a run"), std::string::npos);
  die.write("checkpoint.bin", "none");
  const std::string damaged = refusal({"--state", die.folder().string()});
  EXPECT_NE(damaged.find("--state: found the checkpoint of " + die.folder().string() + ", which is damaged"),
            std::string::npos)
      << damaged;
  EXPECT_EQ(damaged.find("--resume"), std::string::npos) << damaged;
}

// A tenth of the step on two threads is serial, nothing waits: 0.1 + 1.8 / N of its time.
TEST(Bench, PredictsMoreThreadsByAmdahlsLawAndWholeBlocks) {
  const StepCounts counts = {2, 1e-3, 0.1, 0, 160, 1e6};
  EXPECT_NEAR(predict(counts, 16).speedup, 1.9 / (0.1 + 1.8 / 16), 1e-12);
  EXPECT_NEAR(predict(counts, 64).speedup, 1.9 / (0.1 + 1.8 * 3 / 160), 1e-12);
  EXPECT_NEAR(predict(counts, 16).bytes_per_second, 1e9 / (0.1 + 1.8 / 16), 1e-3);
}

// A grain in free flight, in the middle of a box that the user names.
TEST(Bench, TracesEnergiesAndTheFinalGrains) {
  SmallDie die;
  die.write("bed.csv", "id,x,y,z,vx,vy,vz,wx,wy,wz\n1,0.001,0.001,0.002,0.1,0,0,0,0,50\n");
  const Outcome outcome =
      run_program({"bench", "spheres", "--state", (die.folder() / "bed.csv").string(), "--width", "2",
                   "--steps", "20", "--every", "10", "--trace", die.out().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(die.out().string() + ": energy.csv, grains.csv"), std::string::npos)
      << outcome.out;
  std::istringstream energies(contents(die.out() / "energy.csv"));
  std::string line;
  int rows = 0;
  for (std::string next; std::getline(energies, next); ++rows) line = next;
  EXPECT_EQ(rows, 4);  // header, start and two instants
  double time = 0, translation = 0, rotation = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &translation, &rotation), 3);
  constexpr double kRadius = 1.5e-4, kTime = 20 * 2e-6,
                   kMass = 5400 * 4.0 / 3.0 * 3.14159265358979 * kRadius * kRadius * kRadius;
  EXPECT_NEAR(time, kTime, 1e-12);
  EXPECT_NEAR(translation, 0.5 * kMass * (0.01 + 9.81 * 9.81 * kTime * kTime), 1e-7 * translation);
  EXPECT_NEAR(rotation, 0.5 * 0.4 * kMass * kRadius * kRadius * 2500, 1e-7 * rotation);
  // The box is centred: the grain was in its middle and has moved on along x.
  EXPECT_NE(contents(die.out() / "grains.csv").find("\n0,4e-06,"), std::string::npos)
      << contents(die.out() / "grains.csv");
}

TEST(Bench, MakesABedWhenNoneIsGiven) {
  const Outcome outcome = run_program({"bench", "clumps", "--spheres", "1000", "--steps", "10"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("sphere_steps_per_second: "), std::string::npos) << outcome.out;
}

TEST(Bench, NamesTheBedsWhereThereIsNoSuchScene) {
  const Outcome outcome = run_program({"bench", "foo"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("found \"foo\" (allowed: spheres, clumps, a scene file that exists)"),
            std::string::npos)
      << outcome.err;
}

TEST(Bench, RefusesStepsBetweenOutputsWithoutATrace) {
  const Outcome outcome = run_program({"bench", "clumps", "--every", "5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("--trace"), std::string::npos) << outcome.err;
}

TEST(Bench, WrongBedsEndInOneLine) {
  SmallDie die;
  die.write("bed.csv", "id,x\n1,2,3\n");
  const std::string file = (die.folder() / "bed.csv").string();
  const Outcome outcome = run_program({"bench", "spheres", "--state", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(file + ", line 2: 10 numbers per line expected"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
