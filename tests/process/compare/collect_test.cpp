// What a comparison takes from the folders of its runs.
#include "process/compare/collect.h"

#include <gtest/gtest.h>

#include "process/results/storage/result_file.h"
#include "process/results/studies/job_list.h"
#include "process/run/restart/input_record.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

/// Two variants with two seeds each, finished; every run has a state of its own.
void finish_jobs_in(const support::TemporaryFolder& folder) {
  results::JobList list{"Two speeds", {"slow", "fast"}, {}};
  for (const std::string variant : {"slow", "fast"})
    for (const std::uint64_t seed : {1, 2}) {
      list.jobs.push_back({variant, seed, variant + "/seed-" + std::to_string(seed)});
      auto result = results::sample_result();
      result.seed = seed;
      result.state_hash = "state of " + list.jobs.back().folder;
      results::write_results(folder.path() / list.jobs.back().folder, result);
      results::write_report(folder.path() / list.jobs.back().folder, result);
    }
  results::write_job_list(folder.path(), list);
}

TEST(Collect, CountsACopiedFolderOnce) {
  const support::TemporaryFolder folder;
  finish_jobs_in(folder);
  ASSERT_EQ(collect(folder.path()).runs[1].state, "finished");
  fs::remove_all(folder.path() / "slow/seed-2");
  fs::copy(folder.path() / "slow/seed-1", folder.path() / "slow/seed-2", fs::copy_options::recursive);
  const auto comparison = collect(folder.path());
  ASSERT_EQ(comparison.runs.size(), 4U);
  EXPECT_EQ(comparison.runs[0].state, "finished");
  EXPECT_EQ(comparison.runs[1].state, "failed");
  EXPECT_NE(comparison.runs[1].reason.find("holds a copy of slow/seed-1, seed 1"), std::string::npos)
      << comparison.runs[1].reason;
  ASSERT_FALSE(comparison.measures.empty());
  EXPECT_EQ(comparison.measures[0].values[0].seeds, 1U);
  EXPECT_EQ(comparison.measures[0].values[1].seeds, 2U);
  EXPECT_EQ(comparison.field_seeds, (std::vector<std::size_t>{1, 2}));
}

TEST(Collect, TakesEqualResultsOfTwoVariants) {
  const support::TemporaryFolder folder;
  finish_jobs_in(folder);
  fs::remove_all(folder.path() / "fast/seed-1");
  fs::copy(folder.path() / "slow/seed-1", folder.path() / "fast/seed-1", fs::copy_options::recursive);
  for (const auto& run : collect(folder.path()).runs) EXPECT_EQ(run.state, "finished") << run.reason;
}

TEST(Collect, CountsNoRunThatBeganFromOtherContentsOfTheSameState) {
  const support::TemporaryFolder folder;
  finish_jobs_in(folder);
  const auto began_from = [&](const std::string& job, const std::string& name, const std::string& hash) {
    auto result = results::read_results(folder.path() / job);
    add_input_files({{name, hash}}, result);
    results::write_results(folder.path() / job, result);
  };
  began_from("slow/seed-1", "/settled/results.h5", "first");
  began_from("slow/seed-2", "/settled/results.h5", "first");
  began_from("fast/seed-1", "/settled/results.h5", "second");
  began_from("fast/seed-2", "/elsewhere/results.h5", "second");
  const auto comparison = collect(folder.path());
  ASSERT_EQ(comparison.runs.size(), 4U);
  for (const std::size_t same : {0, 1, 3}) EXPECT_EQ(comparison.runs[same].state, "finished") << same;
  EXPECT_EQ(comparison.runs[2].state, "failed");
  EXPECT_NE(comparison.runs[2].reason.find("read different contents of /settled/results.h5 than slow/seed-1"),
            std::string::npos)
      << comparison.runs[2].reason;
}

}  // namespace
}  // namespace diefill::process
