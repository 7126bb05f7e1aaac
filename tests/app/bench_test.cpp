// diefill bench: figures of a bed that it makes or reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

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

TEST(Bench, MakesABedWhenNoneIsGiven) {
  const Outcome outcome = run_program({"bench", "clumps", "--spheres", "1000", "--steps", "10"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("sphere_steps_per_second: "), std::string::npos) << outcome.out;
}

TEST(Bench, WrongBedsEndInOneLine) {
  SmallDie die;
  die.write("bed.csv", "id,x\n1,2,3\n");
  const std::string file = (die.folder() / "bed.csv").string();
  const Outcome outcome = run_program({"bench", "spheres", "--state", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(file + ", line 2: 10 numbers are expected"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
