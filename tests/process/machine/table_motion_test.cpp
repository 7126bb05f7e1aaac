// What is wrong with some tables of a motion.
#include "process/machine/motions/table_motion.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

class MotionFile : public testing::Test {
 protected:
  std::string complaint(const std::string& text) const {
    try {
      read_motion_table(folder_.write("motion.csv", text), "scene.toml:3:8: step.file");
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  }
  support::TemporaryFolder folder_;
};

TEST_F(MotionFile, SaysWhatIsWrongAndWhere) {
  const auto expect = [&](const std::string& text, const std::string& words) {
    EXPECT_NE(complaint(text).find(words), std::string::npos) << complaint(text);
  };
  expect("time s, x mm\n0, 0\n1, abc\n", "motion.csv:3:4: column x: found \"abc\"");
  expect("time s, x kg\n0, 0\n1, 1\n", "\"kg\" is not a unit of length");
  expect("time s, speed\n0, 0\n", "found column \"speed\"");
  expect("x mm\n0\n", "no time column");
  expect("time s, x mm\n0, 0\n0, 1\n", "times must increase");
  expect("time s, x mm\n0, 1\n1, 1\n", "must be all zeros");
  expect("time s, x mm\n0, 0\n1\n", "found 1 values");
  expect("time s, x mm\n0, 0\n", "found 1 points");
  expect("time s,x mm,x mm\n0,0,0\n1,1,2\n", "motion.csv:1:13: found column x twice");
  expect("time s,time s,x mm\n0,0,0\n1,1,2\n", "found column time twice");
  expect("time s\n0\n1\n", "found only a time column");
  expect("time s, x mm\n0, 0\n2, 1\n1, 2\n", "motion.csv:4: found the time 1 s after 2 s");
  expect("time s, x mm\n0, 0\n1e-9, -46\n", "motion.csv:3: found a motion at 4.6e+07 m/s");
  expect("time s, angle deg\n0, 0\n1e-6, 360\n", "allowed: up to 60000 rpm");
  expect("time s, x mm\n0, 0\n1, 1e9\n", "column x: found 1e9 mm, allowed: -10 to 10 m");
  expect("time s, x mm\n0, 0\n1e7, 1\n", "column time: found 1e7 s, allowed: 0 to 1000 s");
  expect("time s;x mm\n0;0\n0,2;-46\n", "\"0,2\", a number with a decimal comma");
}

}  // namespace
}  // namespace diefill::process
