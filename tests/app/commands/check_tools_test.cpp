// What `check` says about tools: repairs, fits, symmetry, JSON and the picture of findings.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

void expect_says(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words << "\nin: " << text;
}

std::string named(std::string text_stl, const std::string& name) {
  for (std::size_t at = text_stl.find("solid "); at != std::string::npos;
       at = text_stl.find("solid ", at + 6)) {
    const std::size_t end = text_stl.find('\n', at);
    text_stl.replace(at, end - at, "solid " + name);
  }
  return text_stl;
}

TEST(CheckTools, SaysWhatWasRepairedAndTheReportDoesToo) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(cad::inside_out(small_die())));
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out, "found: 1 shell faces the wrong way: the whole surface is inside out");
  expect_says(checked.out, "repaired: surface normals reversed to point outward");
  expect_says(checked.out, "note: tool \"die\" repaired: surface normals reversed to point outward");
  ASSERT_EQ(die.run({"--no-pictures"}).exit_code, 0);
  expect_says(die.report()["warnings"].dump(), "repaired: surface normals reversed to point outward");
}

TEST(CheckTools, SaysHowToolsFitAndHowTheyAreSymmetric) {
  const SmallDie die;
  const Outcome checked = die.check();
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out, "die and shoe: in contact without a gap");
  expect_says(checked.out, "symmetry: mirror plane");
  expect_says(checked.out, "narrowest width 4.000 mm near (");
  die.exchange("[\"3 mm\", \"0 mm\", \"0 mm\"]", "[\"3 mm\", \"0 mm\", \"0.4 mm\"]");
  const Outcome lifted = die.check();
  ASSERT_EQ(lifted.exit_code, 0) << lifted.err;
  expect_says(lifted.out, "die and shoe: gap of 0.4 mm");
  EXPECT_EQ(lifted.out.find("to 0.4 mm"), std::string::npos) << lifted.out;
}

TEST(CheckTools, SpaceWherePowderNeverComesIsNoGap) {
  const SmallDie die;
  // The die stands on a table, on feet 1.3 mm high: grains of 1 mm would fit under it.
  die.write("table.stl", cad::binary_stl(cad::prism(cad::rectangle(-15, 6, -3.5, 3.5), -8, -6.3)));
  die.exchange(
      "[pour]",
      "[[tool]]\nname = \"table\"\nrole = \"plate\"\nfile = \"table.stl\"\nlength_unit = \"mm\"\n\n[pour]");
  const Outcome checked = die.check();
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out, "die and shoe: in contact without a gap");
  EXPECT_EQ(checked.out.find("table: gap"), std::string::npos) << checked.out;
}

TEST(CheckTools, PartsOfOneFileArePickedByName) {
  const SmallDie die;
  const std::string both =
      named(cad::text_stl(small_die()), "lower_die") + named(cad::text_stl(small_shoe()), "feed_shoe");
  die.write("press.stl", both);
  die.exchange("file = \"die.stl\"", "file = \"press.stl\"\npart = \"lower_die\"");
  die.exchange("file = \"shoe.stl\"", "file = \"press.stl\"\npart = \"feed_shoe\"");
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  die.exchange("part = \"feed_shoe\"", "part = \"feed_shoo\"");
  const Outcome wrong = die.check();
  EXPECT_EQ(wrong.exit_code, 2);
  expect_says(
      wrong.err,
      "has no part \"feed_shoo\": it contains \"lower_die\", \"feed_shoe\"; did you mean \"feed_shoe\"?");
}

TEST(CheckTools, AMirroredPartStandsOnTheOtherSide) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl([] {
              cad::Part part = cad::inside_out(small_die());
              for (auto& triangle : part)
                for (auto& corner : triangle) corner[0] = -corner[0];
              return part;
            }()));
  die.exchange("file = \"die.stl\"", "file = \"die.stl\"\nmirror = \"x\"");
  const Outcome mirrored = die.check();
  EXPECT_EQ(mirrored.exit_code, 0) << mirrored.err;
  EXPECT_EQ(mirrored.out.find("repaired"), std::string::npos) << mirrored.out;
  expect_says(mirrored.out, "extent: from (-15.00, -3.50, -5.00) to (6.00, 3.50, 0.00) mm");
}

TEST(CheckTools, JsonHoldsTheFindings) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(cad::inside_out(small_die())));
  const Outcome checked = run_program({"check", die.scene().string(), "--json"});
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  const auto json = nlohmann::json::parse(checked.out);
  const auto& tool = json.at("tools").at(0);
  EXPECT_EQ(tool.at("name"), "die");
  EXPECT_EQ(tool.at("found").at("inward_shells"), 1);
  EXPECT_EQ(tool.at("mesh").at("usable"), true);
  EXPECT_EQ(tool.at("repairs").size(), 1U);
  EXPECT_GT(tool.at("wall_spheres").at("count"), 100);
  EXPECT_NEAR(json.at("cavity").at("narrowest_width_m"), 4e-3, 1e-6);
  EXPECT_EQ(json.at("pairs").at(0).at("powder_enters"), false);
}

TEST(CheckTools, ThePictureMarksWhatIsRefused) {
  const SmallDie die;
  cad::Part open = small_die();
  open.pop_back();
  die.write("die.stl", cad::binary_stl(open));
  die.exchange("file = \"die.stl\"", "file = \"die.stl\"\nrepair = \"off\"");
  const auto png = die.folder() / "findings.png";
  const Outcome refused = run_program({"check", die.scene().string(), "--json", "--picture", png.string()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.complaints(), 1U) << refused.err;
  EXPECT_EQ(nlohmann::json::parse(refused.out).at("tools").at(0).at("mesh").at("usable"), false);
  EXPECT_EQ(contents(png).substr(1, 3), "PNG");
}

}  // namespace
}  // namespace diefill::app
