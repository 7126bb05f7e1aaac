// Runs of experiments that are made again because their time step was too long.
#include "process/laboratory/published/halved_steps.h"

#include <gtest/gtest.h>

#include "engine/limits/time_step.h"
#include "process/results/storage/atomic_file.h"
#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

/// Of a scene with these lines in [numerics].
NumericsSpec halved(const std::string& numerics) {
  support::SceneTables tables;
  tables.numerics += numerics;
  SceneFolder folder;
  return at_half_step(read_scene(folder.write(support::scene_text(tables)))).numerics;
}

TEST(HalvedSteps, AreHalfOfWhatTheSceneGives) {
  EXPECT_DOUBLE_EQ(halved("").time_step_fraction, engine::kDefaultTimeStepFraction / 2);
  EXPECT_DOUBLE_EQ(halved("time_step_fraction = 0.4\n").time_step_fraction, 0.2);
  const auto outright = halved("time_step = \"3 us\"\n").time_step;
  ASSERT_TRUE(outright);
  EXPECT_NEAR(*outright, 1.5e-6, 1e-18);
}

/// A folder in which job k of `reasons` ended with this message, outside the valid range.
class EndedJobs {
 public:
  explicit EndedJobs(const std::vector<std::string>& reasons) {
    for (std::size_t k = 0; k < reasons.size(); ++k) {
      const std::string name = "run " + std::to_string(k), place = "run_" + std::to_string(k) + "/seed-1";
      list.jobs.push_back({name, 1, place});
      std::filesystem::create_directories(folder.path() / place);
      results::write_text_atomically(folder.path() / place / kJobExitCode, "3\n");
      results::write_text_atomically(folder.path() / place / kJobLog, "diefill: " + reasons[k] + "\n");
    }
  }
  bool halve() {
    return halve_steps_that_were_too_long(folder.path(), list,
                                          [this](const std::string& note) { notes += note + '\n'; });
  }

  support::TemporaryFolder folder;
  results::JobList list;
  std::string notes;
};

TEST(HalvedSteps, AreTakenByRunsWhoseStepWasTooLongOnce) {
  EndedJobs jobs({"energy grew by 6.7 %: the time step of 2e-08 s is too long", "the powder is too soft"});
  EXPECT_TRUE(jobs.halve());
  EXPECT_EQ(runs_at_half_step(jobs.folder.path()), std::set<std::string>{"run 0"});
  EXPECT_NE(jobs.notes.find("\"run 0\" ended because its time step is too long"), std::string::npos);
  EXPECT_FALSE(jobs.halve()) << "what fails at half the step as well stays failed";
}

TEST(HalvedSteps, AreNoneInANewFolder) {
  const support::TemporaryFolder folder;
  EXPECT_TRUE(runs_at_half_step(folder.path()).empty());
}

}  // namespace
}  // namespace diefill::process::laboratory
