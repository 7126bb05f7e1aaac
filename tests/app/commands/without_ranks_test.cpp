// A program without diefill-mpi beside it says so.
#include <gtest/gtest.h>

#include "project_paths.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(WithoutRanks, ProgramForThemIsAskedFor) {
  const SmallDie die;
  Surroundings elsewhere;
  elsewhere.program = die.folder() / "diefill";
  std::filesystem::copy_file(DIEFILL_PROGRAM, elsewhere.program);
  const Outcome outcome = run_program({"run", die.scene().string(), "--ranks", "2"}, elsewhere);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("DIEFILL_MPI=ON"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

}  // namespace
}  // namespace diefill::app
