// The interactive view of reports in a real browser: built where chromium is installed.
#include <gtest/gtest.h>

#include <cstdlib>

#include "project_paths.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// What the script finds wrong with the view of a page; empty: nothing.
std::string faults(const std::filesystem::path& page, const std::filesystem::path& folder) {
  const auto log = folder / "browser.log";
  const char* pictures = std::getenv("DIEFILL_PICTURES");
  const std::string command = std::string("python3 '") + DIEFILL_SOURCE_DIR +
                              "/tests/app/browser/view_test.py' '" + DIEFILL_CHROMIUM + "' '" +
                              page.string() + "' " + (pictures != nullptr ? pictures : "") + " > '" +
                              log.string() + "' 2>&1";
  return std::system(command.c_str()) == 0 ? "" : contents(log);
}

TEST(View, EveryControlWorksInABrowserThatAsksNobody) {
  const SmallDie die;
  die.write("scene.toml", contents(die.scene()) + "snapshot_interval = \"100 ms\"\n");
  take_shared_results(die);
  ASSERT_EQ(run_program({"report", die.out().string()}).exit_code, 0);
  EXPECT_EQ(faults(die.out() / "report.html", die.folder()), "");
}

TEST(View, RunsOfAComparisonStandSideBySideUnderOneCamera) {
  const SmallDie die;
  die.write("scene.toml", contents(die.scene()) + "snapshot_interval = \"100 ms\"\n");
  take_shared_results(die);
  const auto page = die.folder() / "compared.html";
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.3 m/s\"");
  const auto fast = (die.folder() / "fast").string();
  ASSERT_EQ(run_program({"run", die.scene().string(), "--out", fast, "--quiet", "--no-pictures"}).exit_code,
            0);
  ASSERT_EQ(run_program({"report", die.out().string(), fast, "--out", page.string()}).exit_code, 0);
  EXPECT_EQ(faults(page, die.folder()), "");
}

}  // namespace
}  // namespace diefill::app
