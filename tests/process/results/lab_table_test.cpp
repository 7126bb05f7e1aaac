// Tables of the laboratory keep what they are given.
#include "process/results/studies/lab_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/results/storage/result_file.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

TEST(LabTable, IsReadAsItWasWritten) {
  const support::TemporaryFolder folder;
  LabTable table;
  table.experiment = "mean_fractions";
  table.size = "coarse";
  table.seeds = 2;
  LabRow row;
  row.id = "N01";
  row.published = "0.59";
  row.lower = 0.575;
  row.values = {0.58, 0.6};
  row.verdict = "met";
  row.grain_diameter = 1.2e-3;
  table.rows = {row, {}};
  write_lab_table(folder.path(), table);
  const LabTable read = read_lab_table(folder.path(), "mean_fractions");
  ASSERT_EQ(read.rows.size(), 2U);
  EXPECT_EQ(read.size, "coarse");
  EXPECT_EQ(read.rows[0].values, row.values);
  EXPECT_DOUBLE_EQ(read.rows[0].lower, 0.575);
  EXPECT_TRUE(std::isnan(read.rows[0].upper));
  EXPECT_TRUE(std::isnan(read.rows[1].grain_diameter));
  EXPECT_EQ(here_text(read.rows[0]), "0.59 +- 0.014");
  EXPECT_EQ(published_text(read.rows[0]), "0.59 (at least 0.575)");
  EXPECT_EQ(here_text(read.rows[1]), "-");
}

TEST(LabTable, CountsAreShownWithoutAPowerOfTen) {
  LabRow row;
  row.values = {15626.4};
  EXPECT_EQ(here_text(row), "15626");
  row.values = {1.5e6};
  EXPECT_EQ(here_text(row), "1.5e+06");
}

TEST(LabTable, NamesThatAreNoUtf8AreWritten) {
  const support::TemporaryFolder folder;
  LabTable table;
  table.experiment = "heaps";
  table.powder = "powder_\xe4.toml";
  write_lab_table(folder.path(), table);
  EXPECT_EQ(read_lab_table(folder.path(), "heaps").powder, "powder_\xef\xbf\xbd.toml");
}

TEST(LabTable, AMissingOrForeignFileIsOneLine) {
  const support::TemporaryFolder folder;
  EXPECT_THROW(read_lab_table(folder.path(), "none"), ResultError);
  folder.write("other.json", "{\"a\": 1}");
  EXPECT_THROW(read_lab_table(folder.path(), "other"), ResultError);
}

}  // namespace
}  // namespace diefill::results
