// What a run keeps of the files that it has read.
#include "process/run/restart/input_record.h"

#include <gtest/gtest.h>

#include "process/results/storage/result_file.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

const std::vector<InputFile> kTwoFiles = {{"my motion.csv", "0123456789abcdef"},
                                          {"../settled/results.h5", "fedcba9876543210"}};

TEST(InputRecord, GivesBackWhatWasWritten) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(read_input_record(folder.path()).has_value());
  write_input_record(folder.path(), {});
  EXPECT_FALSE(std::filesystem::exists(input_record_file(folder.path())));
  write_input_record(folder.path(), kTwoFiles);
  const auto read = read_input_record(folder.path());
  ASSERT_TRUE(read && read->size() == kTwoFiles.size());
  for (std::size_t k = 0; k < kTwoFiles.size(); ++k) {
    EXPECT_EQ((*read)[k].name, kTwoFiles[k].name);
    EXPECT_EQ((*read)[k].hash, kTwoFiles[k].hash);
  }
}

TEST(InputRecord, NamesTheFirstFileOfOtherContents) {
  EXPECT_FALSE(changed_file(kTwoFiles, kTwoFiles).has_value());
  auto edited = kTwoFiles;
  edited[1].hash = "0000000000000000";
  EXPECT_EQ(changed_file(edited, kTwoFiles), "../settled/results.h5");
  EXPECT_EQ(changed_file(kTwoFiles, {kTwoFiles[0]}), "../settled/results.h5");
}

TEST(InputRecord, IsFoundBesideACheckpointOrElseWithResults) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(input_files_read_in(folder.path()).has_value());
  auto result = results::sample_result();
  EXPECT_FALSE(recorded_input_files(result).has_value());
  add_input_files(kTwoFiles, result);
  results::write_results(folder.path(), result);
  auto found = input_files_read_in(folder.path());
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(changed_file(kTwoFiles, *found).has_value());
  write_input_record(folder.path(), {kTwoFiles[1]});
  found = input_files_read_in(folder.path());
  ASSERT_TRUE(found && found->size() == 1);
  EXPECT_EQ(found->front().name, kTwoFiles[1].name);
  folder.write("results.h5", "damaged");
  std::filesystem::remove(input_record_file(folder.path()));
  EXPECT_FALSE(input_files_read_in(folder.path()).has_value());
}

}  // namespace
}  // namespace diefill::process
