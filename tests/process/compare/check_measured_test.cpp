// Measured data that no variant's results can have are noticed before anything runs.
#include "process/compare/check_measured.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

/// What is said of a file with scenes of sample_tools/small_dies as variants.
std::string message_of(const std::vector<std::string>& scenes, const std::string& csv) {
  const support::TemporaryFolder folder;
  std::vector<Variant> variants;
  for (const std::string& scene : scenes)
    for (Variant& variant :
         read_variants(std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/small_dies/" + scene))
      variants.push_back(std::move(variant));
  try {
    refuse_unmeasurable(read_measured_files({folder.write("m.csv", csv).string()}), variants);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no message";
}

void expect(const std::string& said, const std::string& part) {
  EXPECT_NE(said.find(part), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

constexpr const char* kOverAzimuth = "azimuth [deg], fill level [mm]\n45, 3\n";

TEST(MeasuredOfVariants, ThatTheirResultsHavePass) {
  EXPECT_EQ(message_of({"ring_6mm.toml"}, kOverAzimuth), "no message");
  EXPECT_EQ(message_of({"square.toml"}, "height [mm], solid fraction [1]\n2, 0.3\n"), "no message");
  EXPECT_EQ(message_of({"square.toml"}, "x [mm], z [mm], along the shoe's motion [1]\n1, 2, 0.3\n"),
            "no message");
}

TEST(MeasuredOfVariants, OfAnotherShapeOfCavityAreRefused) {
  const std::string said = message_of({"square.toml"}, kOverAzimuth);
  expect(said,
         "m.csv:1:1: only rings have a fill level over azimuth, and the cavity is none; allowed: places");
  // One variant that has it is enough: the others stay in without a value.
  EXPECT_EQ(message_of({"square.toml", "ring_6mm.toml"}, kOverAzimuth), "no message");
}

TEST(MeasuredOfVariants, OfUnknownNamesAreRefused) {
  expect(message_of({"square.toml"}, "height [mm], solid fracton [1]\n2, 0.3\n"),
         "did you mean \"solid fraction\"?");
  expect(message_of({"square.toml"}, "x [mm], y [mm], density [1]\n2, 1, 0.3\n"),
         "m.csv:1:17: found \"density\", allowed: \"solid fraction\", \"fill level\", \"along the shoe's "
         "motion\"");
}

}  // namespace
}  // namespace diefill::process
