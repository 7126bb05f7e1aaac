// What a scene does not compute, and where it is refused; how little that changes:
// tests/slow/economy_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "process/results/storage/result_file.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// The small die's scene with lines of [economy].
struct Economical : SmallDie {
  explicit Economical(const std::string& lines) {
    exchange("[numerics]", "[economy]\n" + lines + "\n\n[numerics]");
  }
  nlohmann::json filled() const {
    const Outcome outcome = run({"--no-pictures"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return report();
  }
  /// The same where only the report is needed, perhaps of an earlier run.
  nlohmann::json report_of_filling() const { return shared_report(*this); }
};

double number(const nlohmann::json& report, const char* key) {
  return report.at(key).get<double>();
}

const nlohmann::json& plain() {
  static const nlohmann::json report = Economical("").report_of_filling();
  return report;
}

void expect_refused(const SmallDie& die, const std::vector<std::string>& words,
                    const std::string& key = "economy.mirror") {
  const Outcome outcome = die.run();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(key), std::string::npos) << outcome.err;
}

TEST(Economy, SleepLeavesOutStepsAndSaysSo) {
  const auto asleep = Economical("sleep = true").report_of_filling();
  EXPECT_EQ(number(plain(), "sphere_steps_left_out"), 0);
  EXPECT_GT(number(asleep, "sphere_steps_left_out"), 0.02 * number(asleep, "sphere_steps"));
  EXPECT_LT(std::abs(number(asleep, "energy_balance_error")), 0.01);
  EXPECT_NE(asleep.at("warnings").dump().find("settled grains were frozen"), std::string::npos);
}

TEST(Economy, ComovingPowderLeavesOutStepsAndSaysSo) {
  const auto carried = Economical("carry_beyond = \"2 mm\"").report_of_filling();
  EXPECT_GT(number(carried, "sphere_steps_left_out"), 0.004 * number(carried, "sphere_steps"));
  EXPECT_LT(std::abs(number(carried, "energy_balance_error")), 0.01);
  EXPECT_NE(carried.at("warnings").dump().find("farther than 2 mm from a cavity was moved as a rigid block"),
            std::string::npos);
}

TEST(Economy, PowderIsNotCarriedWhereThatWouldBeWrong) {
  const std::string carry = "carry_beyond = \"2 mm\"", key = "economy.carry_beyond";
  Economical lifted(carry);
  lifted.exchange("[economy]",
                  "[[step]]\nkind = \"move\"\ntool = \"die\"\ndirection = \"-z\"\ndistance = \"1 mm\"\n"
                  "velocity = \"0.1 m/s\"\n\n[economy]");
  expect_refused(lifted, {"moves the die", "remove the key"}, key);

  Economical turned(carry);
  turned.exchange("[economy]",
                  "[[step]]\nkind = \"rotation\"\ntool = \"shoe\"\naxis = \"z\"\nspeed = \"60 rpm\"\n"
                  "ramp = \"20 ms\"\nduration = \"0.1 s\"\n\n[economy]");
  expect_refused(turned, {"would not move with it", "remove the key or the step"}, key);

  Economical without_shoe(carry);
  without_shoe.exchange("role = \"shoe\"", "role = \"plate\"");
  expect_refused(without_shoe, {"no tool has the role \"shoe\"", "remove the key"}, key);
}

/// Runs until a first checkpoint is there, is killed, and resumes.
void expect_restart_ends_alike(const std::string& lines) {
  const Economical unbroken(lines), broken(lines);
  const auto expected = unbroken.filled();
  Program program(broken.run_arguments({"--no-pictures"}));
  while (program.running() && !std::filesystem::exists(broken.out() / "checkpoint.bin")) {
  }
  program.send(SIGKILL);
  program.wait();
  const Outcome outcome = broken.run({"--resume", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* key : {"state_hash", "filled_mass_kg", "steps", "sphere_steps_left_out"})
    EXPECT_EQ(broken.report().at(key), expected.at(key)) << key;
}

TEST(Economy, SleepersOutliveARestart) {
  expect_restart_ends_alike("sleep = true");
}

TEST(Economy, ComovingPowderOutlivesARestart) {
  expect_restart_ends_alike("carry_beyond = \"2 mm\"");
}

TEST(Economy, HalfModelIsMirroredInItsResults) {
  const Economical half("mirror = \"y\"");
  const auto report = half.filled();
  EXPECT_LT(number(report, "sphere_steps") / number(report, "steps"),
            0.6 * number(plain(), "sphere_steps") / number(plain(), "steps"));
  EXPECT_NE(report.at("warnings").dump().find("half model"), std::string::npos);

  const auto result = results::read_results(half.out());
  const auto& powder = result.powder;
  std::map<std::uint64_t, std::size_t> place;
  for (std::size_t k = 0; k < powder.id.size(); ++k) place[powder.id[k]] = k;
  EXPECT_EQ(place.size(), powder.id.size());
  std::size_t images = 0;
  for (std::size_t k = 0; k < powder.id.size(); ++k) {
    if (powder.id[k] >> 32 != 0) continue;
    const std::size_t image = place.at(powder.id[k] + (std::uint64_t{1} << 32));
    ++images;
    EXPECT_GE(powder.position[k].y(), 0.9 * powder.sphere_radius) << "none has gone through the plane";
    EXPECT_EQ(powder.position[image].y(), -powder.position[k].y());
    EXPECT_EQ(powder.position[image].x(), powder.position[k].x());
    const auto& stress = result.contact_stress;
    EXPECT_EQ(stress.normal[image], stress.normal[k]);
    EXPECT_EQ(stress.shear[image], stress.shear[k].cwiseProduct(Eigen::Vector3d(-1, 1, -1)));
  }
  EXPECT_EQ(2 * images, powder.id.size());
  for (const auto& tool : result.tools) {
    double balance = 0;
    for (const auto& centre : tool.wall_sphere_centres) balance += centre.y();
    EXPECT_NEAR(balance, 0, 1e-9) << tool.name << ": its wall spheres are there on both sides";
  }
}

TEST(Economy, HalfModelIsRefusedWhereHalvesDiffer) {
  Economical askew("mirror = \"y\"");
  askew.exchange("position = [\"3 mm\", \"0 mm\"", "position = [\"3 mm\", \"0.4 mm\"");
  expect_refused(askew, {"tool \"shoe\"", "not symmetric across the plane y = 0"});

  const std::string shake =
      "[[step]]\nkind = \"vibration\"\ntool = \"die\"\namplitude = \"0.1 mm\"\nfrequency = \"100 Hz\"\n"
      "duration = \"0.1 s\"\naxis = ";
  Economical shaken("mirror = \"y\"");
  shaken.exchange("[economy]", shake + "[0, 1, 0]\n\n[economy]");
  expect_refused(shaken, {"vibration of die", "out of the mirror plane y = 0", "remove the key"});

  Economical turned("mirror = \"y\"");
  turned.exchange(
      "[economy]",
      "[[step]]\nkind = \"rotation\"\ntool = \"die\"\naxis = \"z\"\nspeed = \"60 rpm\"\nramp = \"20 ms\"\n"
      "duration = \"0.1 s\"\n\n[economy]");
  expect_refused(turned, {"out of the mirror plane y = 0"});
}

TEST(Economy, FarWallsAreThereWhenAskedFor) {
  const auto report = Economical("skip_far_walls = false").report_of_filling();
  EXPECT_GT(number(report, "wall_spheres"), 1.5 * number(plain(), "wall_spheres"));
  EXPECT_GT(number(report, "filled_mass_kg"), 0);
}

TEST(Economy, SpilledGrainsThatAreKeptAreGoneInTheEnd) {
  const auto report = Economical("drop_spilled = false").report_of_filling();
  EXPECT_EQ(number(report, "grains") + number(report, "grains_left") + number(report, "grains_sheared"), 138);
}

TEST(Suction, IsTheSameOnAnyNumberOfThreadsAndSaysWhatItTakesFor) {
  const SmallDie die;
  die.exchange("[numerics]", "[suction]\ntool = \"shoe\"\nparticle_diameter = \"0.1 mm\"\n\n[numerics]");
  std::vector<std::string> hashes;
  for (const char* threads : {"1", "2"}) {
    const Outcome outcome = run_program(
        {"run", die.scene().string(), "--out", die.out().string(), "--no-pictures", "--threads", threads});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    hashes.push_back(die.report().at("state_hash").get<std::string>());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0], plain().at("state_hash").get<std::string>());
  bool said = false;
  for (const auto& topic : results::read_results(die.out()).topics)
    said = said || std::ranges::find(topic.name, "Suction") != topic.name.end();
  EXPECT_TRUE(said);
}

}  // namespace
}  // namespace diefill::app
