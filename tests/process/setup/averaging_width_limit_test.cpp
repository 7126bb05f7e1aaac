// The widest Gaussian that fields of a scene may be averaged with.
#include "process/setup/averaging_width_limit.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

Scene scene_with_width(const std::string& width) {
  const SceneFolder folder;
  return read_scene(folder.write(support::exchanged(faultless_scene(), "fill_plane = \"0 mm\"\n",
                                                    "averaging_width = \"" + width + "\"\n")));
}

/// A block 40 x 40 x 25 mm in size, whose cavity, where it has one, is 8 x 6 x 12 mm in size.
Tooling tools_of_a_block(bool with_cavity) {
  Tooling tooling;
  tooling.all.include(Eigen::Vector3d(-0.02, -0.02, -0.025));
  tooling.all.include(Eigen::Vector3d(0.02, 0.02, 0));
  tooling.cavity.found = with_cavity;
  tooling.cavity.box.include(Eigen::Vector3d(0, 0, -0.012));
  tooling.cavity.box.include(Eigen::Vector3d(0.008, 0.006, 0));
  return tooling;
}

std::string refused(const Scene& scene, const Tooling& tooling) {
  try {
    refuse_wide_averaging(scene, tooling);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(AveragingWidthLimit, IsTheLargestEdgeOfTheCavity) {
  EXPECT_EQ(refused(scene_with_width("12 mm"), tools_of_a_block(true)), "");
  const std::string message = refused(scene_with_width("12.1 mm"), tools_of_a_block(true));
  EXPECT_NE(message.find("scene.toml:"), std::string::npos) << message;
  EXPECT_NE(message.find(": measure.averaging_width: found 12.1 mm, allowed: at most 12 mm, the largest edge "
                         "of the cavity"),
            std::string::npos)
      << message;
}

TEST(AveragingWidthLimit, IsThatOfToolsAndPowderWhereThereIsNoCavity) {
  Scene scene = scene_with_width("60 mm");
  EXPECT_EQ(refused(scene, tools_of_a_block(false)), "");  // the pour box reaches as far
  scene.pour.upper = scene.pour.lower;
  EXPECT_NE(refused(scene, tools_of_a_block(false))
                .find("allowed: at most 40 mm, the largest edge of the box about"),
            std::string::npos)
      << refused(scene, tools_of_a_block(false));
}

TEST(AveragingWidthLimit, ScenesWithoutAWidthHaveTheDefault) {
  const SceneFolder folder;
  EXPECT_EQ(refused(read_scene(folder.write(faultless_scene())), tools_of_a_block(true)), "");
}

}  // namespace
}  // namespace diefill::process
