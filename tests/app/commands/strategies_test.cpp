// Filling strategies from scene to report: shaking, volumetric filling, tools under force control, powder
// that comes and goes, probes and snapshots.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <sstream>
#include <thread>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

const std::string kVelocity = "velocity = \"0.1 m/s\"\n";
/// Values of a probe, row after row, from its CSV file.
std::vector<std::vector<double>> rows_of(const SmallDie& die, const std::string& file) {
  std::istringstream text(contents(die.out() / file));
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(text, line);  // headings
  while (std::getline(text, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// The passage with the whole tooling shaken meanwhile, and all that is recorded.
void shake(const SmallDie& die) {
  die.exchange("kind = \"passage\"", "kind = \"passage\"\nname = \"passage\"");
  die.exchange(kVelocity, kVelocity + R"(
[[step]]
kind = "vibration"
tools = ["die", "shoe"]
axis = "y"
amplitude = "0.3 mm"
frequency = "30 Hz"
start = { with = "passage" }
until = { after = "passage" }

[[step]]
kind = "rotational oscillation"
tool = "die"
through = ["-3 mm", "0 mm", "0 mm"]
amplitude = "2 deg"
frequency = "20 Hz"
duration = "0.15 s"

[[probe]]
name = "filled mass"
quantity = "filled mass"
interval = "5 ms"

[[probe]]
name = "on the die"
quantity = "load"
tool = "die"
interval = "5 ms"

[[snapshot]]
name = "passed"
when = { after = "passage" }
)");
}

TEST(Strategies, ShakenToolingComesBackAndIsMeasuredWhereItIs) {
  const SmallDie die;
  shake(die);
  const Outcome outcome = die.run({"--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("1 passage at 0.1 m/s and vibration of die and shoe at 30 Hz"),
            std::string::npos)
      << outcome.err;
  const auto report = die.report();
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.005);
  const auto rows = rows_of(die, "probe_filled_mass.csv");
  ASSERT_GT(rows.size(), 20U);
  EXPECT_EQ(rows.front().at(1), 0);
  EXPECT_NEAR(rows.back().at(1), report.at("filled_mass_kg").get<double>(), 1e-12);
  // The die carries what lies in it and on it at the end.
  const auto loads = rows_of(die, "probe_on_the_die.csv");
  const double weight = 9.81 * (report.at("grains").get<double>() * 7.63e-8 * std::pow(1 / 0.3, 3));
  EXPECT_NEAR(-loads.back().at(3) / weight, 1, 0.1);
  const auto result = results::read_results(die.out());
  ASSERT_EQ(result.probes.size(), 2U);
  EXPECT_EQ(result.probes[1].columns.size(), 10U);
  EXPECT_EQ(result.probes[1].values.size(), 10 * loads.size());
  const auto snapshot = results::read_results(die.out() / "snapshots" / "passed");
  EXPECT_LT(snapshot.powder.time, result.powder.time);
  EXPECT_GT(snapshot.powder.time, 0.1);
}

TEST(Strategies, GoOnAfterAKillAsIfNothingHadHappened) {
  const SmallDie die, other;
  shake(die);
  shake(other);
  ASSERT_EQ(other.run({"--quiet", "--no-pictures"}).exit_code, 0);
  for (const int milliseconds : {700, 900}) {
    Program program(die.run_arguments({"--resume", "--quiet", "--no-pictures"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(SIGKILL);
    program.wait();
  }
  const Outcome last = die.run({"--resume", "--quiet", "--no-pictures"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(die.report().at("state_hash"), other.report().at("state_hash"));
  for (const char* file : {"probe_filled_mass.csv", "probe_on_the_die.csv"})
    EXPECT_EQ(contents(die.out() / file), contents(other.out() / file)) << file;
}

TEST(Strategies, AnOpenPunchSucksThePowderIn) {
  const SmallDie die;
  // Grains of 1 mm arch over the 4 mm with one seed of four.
  die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.75 mm\"");
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.2 mm\"");
  die.write("die.stl", cad::binary_stl(cad::tube(cad::rectangle(-15, 6, -3.5, 3.5),
                                                 cad::rectangle(-5, -1, -2, 2), -5, 0)));
  die.exchange("[\"3 mm\", \"0 mm\", \"0 mm\"]", "[\"-3 mm\", \"0 mm\", \"0 mm\"]");
  die.exchange("from = [\"0.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]",
               "from = [\"-5.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"-0.5 mm\", \"2.5 mm\", \"9 mm\"]");
  die.add_tool("punch", "punch", cad::prism(cad::rectangle(-4.98, -1.02, -1.98, 1.98), -5, -4),
               "[\"0 mm\", \"0 mm\", \"4 mm\"]");
  die.exchange_passage(R"([[step]]
kind = "move"
tool = "punch"
direction = "-z"
distance = "4 mm"
velocity = "0.05 m/s"

[[probe]]
name = "level"
quantity = "fill level"
interval = "10 ms"

[[probe]]
name = "flow"
quantity = "flow"
origin = ["0 mm", "0 mm", "0 mm"]
interval = "10 ms"
)");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  // 4 x 4 x 4 mm, though there was no room at the start.
  EXPECT_NEAR(report.at("cavity_volume_m3").get<double>(), 64e-9, 2e-9);
  EXPECT_GT(report.at("filled_mass_kg").get<double>(), 0.3 * 64e-9 * 5397);
  const auto level = rows_of(die, "probe_level.csv"), flow = rows_of(die, "probe_flow.csv");
  EXPECT_NEAR(level.back().at(1), 4e-3, 0.8e-3);
  // What is spilled over the die's edge goes through the same plane.
  const double filled = report.at("filled_mass_kg").get<double>();
  EXPECT_GE(flow.back().at(1), filled - 1e-12);
  EXPECT_LE(flow.back().at(1), filled + report.at("mass_left_kg").get<double>() + 1e-12);
}

TEST(Strategies, APistonReachesItsForce) {
  const SmallDie die;
  die.pour_into_the_pocket();
  die.add_tool("piston", "punch", cad::prism(cad::rectangle(-4.8, -1.2, -1.8, 1.8), 2, 4),
               "[\"0 mm\", \"0 mm\", \"1 mm\"]");
  die.exchange_passage(R"([[step]]
kind = "piston"
tool = "piston"
direction = "-z"
force = "0.05 N"
speed_limit = "0.05 m/s"
travel = "6.5 mm"
duration = "0.4 s"

[[probe]]
name = "piston"
quantity = "load"
tool = "piston"
interval = "10 ms"
)");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(die, "probe_piston.csv");
  // The step is over 0.4 s after the powder has come to rest; the last rows before that.
  double sum = 0;
  int count = 0;
  for (const auto& row : rows)
    if (row.at(0) > 0.4 && row.at(3) > 1e-3) {
      sum += row.at(3);
      ++count;
    }
  ASSERT_GT(count, 5);
  EXPECT_NEAR(sum / count, 0.05, 0.005);
}

/// The pocket full of powder, pressed and unloaded by a piston in turn.
void press_in_cycles(const SmallDie& die) {
  die.pour_into_the_pocket();
  die.add_tool("piston", "punch", cad::prism(cad::rectangle(-4.8, -1.2, -1.8, 1.8), 2, 4),
               "[\"0 mm\", \"0 mm\", \"1 mm\"]");
  die.exchange_passage(R"([[step]]
kind = "piston"
tool = "piston"
direction = "-z"
forces = ["0.05 N", "0.01 N", "0.05 N", "0.01 N"]
pause = "10 ms"
retreat = "0.3 mm"
speed_limit = "0.05 m/s"
travel = "6.5 mm"

[[probe]]
name = "piston"
quantity = "load"
tool = "piston"
interval = "1 ms"
)");
}

TEST(Strategies, APistonCyclesBetweenForcesAndRetreats) {
  const SmallDie die;
  press_in_cycles(die);
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(die, "probe_piston.csv");
  double highest = 0, lowest = 0;
  bool low = true;
  int loads = 0, unloads = 0;
  for (const auto& row : rows) {
    const double force = row.at(3);
    highest = std::max(highest, force);
    lowest = std::min(lowest, row.at(9));
    if (low && force > 0.99 * 0.05) ++loads, low = false;
    if (!low && force < 1.01 * 0.01) ++unloads, low = true;
  }
  EXPECT_EQ(loads, 2);
  EXPECT_EQ(unloads, 2);
  EXPECT_LE(highest, 1.02 * 0.05);
  // Unloading takes a part of the way back, the retreat the rest; then it stands clear of the powder.
  EXPECT_GT(rows.back().at(9) - lowest, 0.3e-3);
  EXPECT_LT(rows.back().at(9) - lowest, 0.6e-3);
  EXPECT_EQ(rows.back().at(3), 0);
}

TEST(Strategies, APistonThatCyclesGoesOnAfterAKill) {
  const SmallDie die, other;
  press_in_cycles(die);
  press_in_cycles(other);
  ASSERT_EQ(other.run({"--quiet", "--no-pictures"}).exit_code, 0);
  for (const int milliseconds : {700, 900}) {
    Program program(die.run_arguments({"--resume", "--quiet", "--no-pictures"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(SIGTERM);
    program.wait();
  }
  const Outcome last = die.run({"--resume", "--quiet", "--no-pictures"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(die.report().at("state_hash"), other.report().at("state_hash"));
  EXPECT_EQ(contents(die.out() / "probe_piston.csv"), contents(other.out() / "probe_piston.csv"));
}

TEST(Strategies, PowderComesInAndIsClearedAway) {
  const SmallDie die;
  die.exchange("kind = \"passage\"", R"(kind = "inflow"
name = "top up"
from = ["1.5 mm", "-1.5 mm", "8 mm"]
to = ["4.5 mm", "1.5 mm", "9 mm"]
velocity = ["0 m/s", "0 m/s", "-0.3 m/s"]
mass = "80 mg"
rate = "1 g/s"
with = "shoe"

[[step]]
kind = "passage")");
  die.exchange(kVelocity, kVelocity + "\n[[step]]\nkind = \"clear\"\n");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  const double grain = 7.63e-8 * std::pow(1 / 0.3, 3);
  const double come = std::ceil(80e-6 / grain);
  EXPECT_EQ(report.at("grains").get<double>() + report.at("grains_left").get<double>(), 138 + come);
  EXPECT_NEAR(report.at("grains").get<double>() * grain, report.at("filled_mass_kg").get<double>(),
              3 * grain);  // some roll out after
}

TEST(Strategies, WallsHoldPowderThatComesInAboveWhatWasPoured) {
  const SmallDie die;
  die.exchange("\"9 mm\"]\nfill_height = \"5 mm\"", "\"2 mm\"]\nfill_height = \"0.5 mm\"");
  die.exchange_passage(R"([[step]]
kind = "inflow"
from = ["0.7 mm", "-2.3 mm", "8 mm"]
to = ["5.3 mm", "2.3 mm", "8 mm"]
mass = "80 mg"
)");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = results::read_results(die.out());
  double highest = 0;
  for (const auto& tool : result.tools)
    for (const auto& centre : tool.wall_sphere_centres) highest = std::max(highest, centre.z());
  EXPECT_GT(highest, 8e-3);
}

}  // namespace
}  // namespace diefill::app
