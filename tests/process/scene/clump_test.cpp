// Clumps of the user's own hang together.
#include <gtest/gtest.h>

#include <fstream>

#include "process/scene/scene.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// What is said of a clump whose file has these lines (mm).
std::string complaint(const std::string& lines) {
  const SceneFolder folder;
  std::ofstream(folder.path() / "grain.csv") << "x [mm], y [mm], z [mm], radius [mm]\n" << lines;
  try {
    read_scene(folder.write(support::exchanged(faultless_scene(),
                                               "preset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n",
                                               "spheres_file = \"grain.csv\"\ngrain_mass = \"5e-6 kg\"\n")));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(Clump, InPiecesIsRefusedWithTheGapBetweenThem) {
  const std::string apart = complaint("0, 0, 0, 0.4\n5, 0, 0, 0.4\n");
  for (const char* part : {"scene.toml:",
                           "powder.spheres_file: found \"grain.csv\", sphere 2 is 4.2 mm away "
                           "from sphere 1, the nearest of the others",
                           "let every sphere touch or overlap another one"})
    EXPECT_NE(apart.find(part), std::string::npos) << apart;
  // Two pairs, each of which hangs together.
  const std::string pairs = complaint("0, 0, 0, 0.4\n0.5, 0, 0, 0.4\n3, 0, 0, 0.4\n3.5, 0, 0, 0.4\n");
  EXPECT_NE(pairs.find("sphere 3 is 1.7 mm away from sphere 2"), std::string::npos) << pairs;
}

TEST(Clump, OfTouchingSpheresIsOne) {
  EXPECT_EQ(complaint("0, 0, 0, 0.4\n"), "");
  EXPECT_EQ(complaint("0, 0, 0, 0.4\n0.8, 0, 0, 0.4\n"), "");
  EXPECT_EQ(complaint("0, 0, 0, 0.4\n1.603, 0, 0, 0.4\n0.8, 0, 0, 0.4\n"), "") << "rounded, over the third";
  EXPECT_EQ(complaint("0, 0, 0, 0.4\n0.1, 0, 0, 0.1\n"), "") << "one inside the other";
}

}  // namespace
}  // namespace diefill::process
