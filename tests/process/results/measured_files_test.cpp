// A comparison with measured data replaces its own earlier files and no others.
#include "process/results/studies/measured_files.h"

#include <gtest/gtest.h>

#include "process/results/studies/measured_comparison.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

TEST(MeasuredFiles, OfTheUserAreNamedAndThoseOfAComparisonAreNot) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(foreign_measured_file(folder.path(), "x").has_value());
  folder.write("measured_x.csv", "azimuth [deg], fill level [mm]\n1, 2\n");
  EXPECT_EQ(foreign_measured_file(folder.path(), "x"), folder.path() / "measured_x.csv");
  EXPECT_FALSE(foreign_measured_file(folder.path(), "y").has_value());
  MeasuredComparison comparison;
  comparison.name = "x";
  comparison.quantity = "fill level";
  comparison.unit = "mm";
  comparison.first_name = "azimuth";
  comparison.first_unit = "deg";
  write_measured_comparison(folder.path(), comparison);
  EXPECT_FALSE(foreign_measured_file(folder.path(), "x").has_value());
}

}  // namespace
}  // namespace diefill::results
