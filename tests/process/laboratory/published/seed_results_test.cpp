// Results of an experiment's runs.
#include <gtest/gtest.h>

#include "process/laboratory/published/scene_experiment.h"
#include "process/results/storage/result_file.h"
#include "process/scene/snapshot_folder.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

TEST(SeedResults, HaveSnapshotsOfAnyName) {
  const support::TemporaryFolder folder;
  const auto stored = results::sample_result();
  for (const std::string name : {"settled", "passing 0"}) {
    const auto place = folder.path() / "snapshots" / snapshot_folder(name);
    std::filesystem::create_directories(place);
    results::write_results(place, stored);
  }
  const SeedResults seed(1, {{"run", folder.path()}});
  for (const std::string name : {"settled", "passing 0"})
    EXPECT_EQ(seed.at("run", name).state_hash, stored.state_hash) << name;
}

}  // namespace
}  // namespace diefill::process::laboratory
