// What users are told to do about a tool: possible, and short whatever its file holds.
#include <gtest/gtest.h>

#include "process/tooling/examination/tool_scale.h"
#include "process/tooling/tooling.h"

namespace diefill::process {
namespace {

/// A cube of 1 mm without triangles, read in mm.
void make_cube(Tool& tool) {
  tool.spec.name = "die";
  tool.metres_per_unit = 1e-3;
  tool.mesh.vertices = {{0, 0, 0}, {1e-3, 1e-3, 1e-3}};
}

TEST(ToolScale, NamesLengthUnitOnlyWhereTheSceneHasItToSay) {
  Tool tool;
  make_cube(tool);
  EXPECT_NE(unit_advice(tool, 25.4).find("seems to be in inch; write length_unit = \"inch\""),
            std::string::npos)
      << unit_advice(tool, 25.4);
  tool.unit_from_file = true;
  EXPECT_NE(
      unit_advice(tool, 25.4).find("seems to be in inch, but states another unit; export it again in inch"),
      std::string::npos)
      << unit_advice(tool, 25.4);
}

TEST(UnusableTool, ThreeOfAThousandHolesAreListed) {
  Tool tool;
  make_cube(tool);
  tool.findings.triangles = 12;
  tool.findings.open_edges = 3000;
  tool.findings.places.emplace_back(0, 0, 0);
  for (int hole = 1; hole <= 1000; ++hole) tool.not_repaired.push_back("hole " + std::to_string(hole));
  try {
    refuse_unusable(Scene{}, tool);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("; not repaired: hole 3; and 997 more that are not repaired; repair the CAD"),
              std::string::npos)
        << message;
    EXPECT_EQ(message.find("hole 4"), std::string::npos) << message;
  }
}

TEST(UnusableTool, TellsWhatIsOddAboutItsFile) {
  Tool tool;
  make_cube(tool);
  tool.findings.triangles = 12;
  tool.findings.open_edges = 3;
  tool.findings.places.emplace_back(0, 0, 0);
  tool.file_remarks = {"200 bytes after the last triangle ignored"};
  try {
    refuse_unusable(Scene{}, tool);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("; its file: 200 bytes after the last triangle ignored; repair the CAD"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace diefill::process
