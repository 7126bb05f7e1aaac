// [[measure.zone]] of a scene.
#include "process/scene/zones.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"

namespace diefill::process {
namespace {

std::string complaint(const std::string& text) {
  try {
    zones_in(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(SceneZones, AreBoxesCylindersAndHeights) {
  const auto zones = zones_in(
      "[[measure.zone]]\nname = \"flange\"\nfrom = [\"-8 mm\", \"-8 mm\", \"-5 mm\"]\n"
      "to = [\"8 mm\", \"8 mm\", \"0 mm\"]\n"
      "[[measure.zone]]\nname = \"hub\"\naxis = [\"1 mm\", \"0 mm\", \"0 mm\"]\nouter_radius = \"4 mm\"\n"
      "heights = [\"-20 mm\", \"-5 mm\"]\n");
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_TRUE(zones[0].contains({7e-3, -7e-3, -1e-3}));
  EXPECT_FALSE(zones[0].contains({7e-3, -7e-3, -6e-3}));
  EXPECT_TRUE(zones[1].contains({4.9e-3, 0, -6e-3}));
  EXPECT_FALSE(zones[1].contains({-3.1e-3, 0, -6e-3}));
  EXPECT_FALSE(zones[1].contains({1e-3, 0, -4e-3}));
  EXPECT_TRUE(zones_in("title = \"no zones\"\n").empty());
}

TEST(SceneZones, FaultsAreNamedInOneLine) {
  const std::string zone = "[[measure.zone]]\nname = \"hub\"\n";
  EXPECT_NE(complaint(zone).find("a zone needs a limit"), std::string::npos);
  EXPECT_NE(complaint(zone + "heights = [\"2 mm\", \"1 mm\"]\n").find("the lower one first"),
            std::string::npos);
  EXPECT_NE(
      complaint(zone + "inner_radius = \"2 mm\"\nouter_radius = \"1 mm\"\n").find("more than inner_radius"),
      std::string::npos);
  EXPECT_NE(complaint(zone + "outer_radus = \"1 mm\"\nheights = [\"1 mm\", \"2 mm\"]\n").find("outer_radius"),
            std::string::npos);
  EXPECT_NE(complaint(zone + "from = [\"0 mm\", \"0 mm\", \"0 mm\"]\n").find("to"), std::string::npos);
  EXPECT_NE(complaint(zone + "from = [\"0 mm\", \"0 mm\", \"0 mm\"]\nto = [\"1 mm\", \"0 mm\", \"1 mm\"]\n")
                .find("the box is empty"),
            std::string::npos);
  const std::string box =
      zone + "from = [\"-1 mm\", \"-1 mm\", \"0 mm\"]\nto = [\"1 mm\", \"1 mm\", \"2 mm\"]\n";
  EXPECT_NE(complaint(box + "heights = [\"2 mm\", \"3 mm\"]\n").find("contains nothing"), std::string::npos);
  EXPECT_EQ(complaint(box + "heights = [\"1 mm\", \"3 mm\"]\n"), "no complaint");
  EXPECT_NE(complaint(box + "inner_radius = \"1.5 mm\"\n").find("lies within this radius"),
            std::string::npos);
  EXPECT_EQ(complaint(box + "inner_radius = \"1.4 mm\"\n"), "no complaint");
  const std::string offset_axis = "axis = [\"4 mm\", \"0 mm\", \"0 mm\"]\n";
  EXPECT_NE(complaint(box + offset_axis + "outer_radius = \"3 mm\"\n").find("lies outside this cylinder"),
            std::string::npos);
  EXPECT_EQ(complaint(box + offset_axis + "outer_radius = \"3.1 mm\"\n"), "no complaint");
  const std::string good = "heights = [\"1 mm\", \"2 mm\"]\n";
  EXPECT_NE(complaint(zone + good + "[[measure.zone]]\nname = \"hub\"\n" + good).find("a name of its own"),
            std::string::npos);
}

}  // namespace
}  // namespace diefill::process
