// Set-ups that cannot be meant: tools that pass through each other, powder beside the shoe, no cavity.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

void expect_says(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words << "\nin: " << text;
}

void expect_refused(const SmallDie& die, const std::string& words) {
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 2) << checked.out;
  EXPECT_EQ(checked.complaints(), 1U) << checked.err;
  expect_says(checked.err, words);
}

constexpr const char* kShoePlace = "[\"3 mm\", \"0 mm\", \"0 mm\"]";

TEST(ToolPaths, AShoeThatGoesThroughTheDieIsRefusedWithTimeAndPlace) {
  const SmallDie die;
  die.exchange_passage(
      "[[step]]\nkind = \"move\"\ntool = \"shoe\"\ndirection = \"-z\"\ndistance = \"3 mm\"\nvelocity = \"0.1 "
      "m/s\"\n");
  expect_refused(die, "tool \"shoe\" penetrates tool \"die\" 0.0");
  expect_says(die.check().err, "up to 1.5 mm deep; change the motion or move one of the tools");
  const auto png = die.folder() / "findings.png";
  EXPECT_EQ(run_program({"check", die.scene().string(), "--picture", png.string()}).exit_code, 2);
  EXPECT_EQ(contents(png).substr(1, 3), "PNG");
  const Outcome run = die.run();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

TEST(ToolPaths, AThousandPassagesAreLookedAtAsAFew) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.1 m/s\"\npassages = 1000");
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out, "strategy: 1000 passages");
}

TEST(Setup, APlainFillingHasNoOtherWarningThanItsCoarseGrains) {
  const SmallDie die;
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(checked.out.find("shoe \""), std::string::npos) << checked.out;
  EXPECT_EQ(checked.out.find("pour box"), std::string::npos) << checked.out;
}

TEST(Setup, PowderPouredBesideTheShoeIsTold) {
  const SmallDie die;
  die.exchange("from = [\"0.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]",
               "from = [\"-14 mm\", \"-2.5 mm\", \"0.1 mm\"]\nto = [\"-9 mm\", \"2.5 mm\", \"9 mm\"]");
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out, "WARNING\n  ! 100 % of the pour box");
  const Outcome run = die.run({"--no-pictures"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("WARNING\n  ! 100 % of the pour box")) << run.out;
  const std::string end = run.out.substr(run.out.find("results in"));
  expect_says(end, "WARNING\n  ! 100 % of the pour box");
  expect_says(end, "left the tools");
  expect_says(end, "of the powder that would fill it");
  const auto report = die.report();
  EXPECT_GT(report.at("grains_left_share"), 0.02);
  expect_says(report.at("warnings").dump(), "left the tools");
}

// 5 x 5 mm of powder 4.5 mm high are 113 mm3, the cavity's 64 mm3 are less; half of it would not fill it.
TEST(Setup, TooLittlePowderIsToldOfBothHalvesOfAHalfModel) {
  const SmallDie die;
  die.exchange("fill_height = \"5 mm\"", "fill_height = \"4.5 mm\"");
  die.exchange("[[step]]", "[economy]\nmirror = \"y\"\n\n[[step]]");
  const Outcome enough = die.check();
  EXPECT_EQ(enough.exit_code, 0) << enough.err;
  EXPECT_EQ(enough.out.find("not enough to fill it"), std::string::npos) << enough.out;
  die.exchange("fill_height = \"4.5 mm\"", "fill_height = \"2 mm\"");
  expect_says(die.check().out, "0.05 cm3 of powder are poured, 78 % of the cavity's 0.064 cm3");
}

/// Powder that rains on the shoe before its passage.
void let_in(const SmallDie& die, const std::string& from, const std::string& to, const std::string& rate) {
  die.exchange("[[step]]", "[[step]]\nname = \"rain\"\nkind = \"inflow\"\nfrom = " + from + "\nto = " + to +
                               "\nmass = \"0.05 g\"\nrate = \"" + rate + "\"\n\n[[step]]");
}

TEST(Inflow, ThatFallsFasterThanItsBoxHasRoomForIsTold) {
  const SmallDie slow, fast;
  const std::string from = R"(["1 mm", "-2 mm", "11 mm"])", to = R"(["5 mm", "2 mm", "20 mm"])";
  let_in(slow, from, to, "0.1 g/s");
  let_in(fast, from, to, "400 g/s");
  const Outcome checked = fast.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_says(checked.out,
              "rate is 400 g/s, but the box from (1, -2, 11) to (5, 2, 20) mm delivers at most about ");
  expect_says(checked.out, "enlarge the box, give the grains a velocity, or reduce the rate");
  const Outcome as_it_can = slow.check();
  EXPECT_EQ(as_it_can.exit_code, 0) << as_it_can.err;
  EXPECT_EQ(as_it_can.out.find("delivers at most about"), std::string::npos) << as_it_can.out;
}

TEST(Inflow, FromABoxInsideAToolIsRefused) {
  const SmallDie die;
  let_in(die, R"(["-14 mm", "-2 mm", "-4 mm"])", R"(["-8 mm", "2 mm", "-1 mm"])", "0.1 g/s");
  expect_refused(
      die, "the box from (-14, -2, -4) to (-8, 2, -1) mm lies inside a tool or leaves no space for a grain");
}

TEST(FineWalls, AreRemarkedOnFromATwelfthOfTheGrainsRadiusOn) {
  const SmallDie die;
  // Refused soon afterwards, so that nothing need be covered.
  die.write("die.stl", cad::binary_stl(cad::prism(cad::rectangle(-15, 6, -3.5, 3.5), -5, 0)));
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.041 mm\"");
  const std::string remark = "note: walls.sphere_radius is 0.041 mm, 1/12 of the grain radius of 0.5 mm";
  expect_says(die.check().err, remark);
  die.exchange("sphere_radius = \"0.041 mm\"", "sphere_radius = \"0.043 mm\"");
  EXPECT_EQ(die.check().err.find("note: walls.sphere_radius"), std::string::npos);
}

TEST(Setup, AShoeAboveTheDieIsTold) {
  const SmallDie die;
  die.exchange(kShoePlace, "[\"3 mm\", \"0 mm\", \"3 mm\"]");
  expect_says(die.check().out, "shoe \"shoe\" is 3 mm above the fill plane");
}

TEST(Setup, AShoeNarrowerThanTheCavityIsTold) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(cad::block_with_pocket(cad::rectangle(-15, 6, -3.5, 3.5),
                                                              cad::rectangle(-5, -1, -3, 3), -5, -4, 0)));
  expect_says(die.check().out, "the opening of shoe \"shoe\" never passes over part of the cavity");
}

TEST(Setup, AWayThatEndsBeforeTheCavityIsTold) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.1 m/s\"\ntravel = \"0.5 mm\"");
  expect_says(die.check().out, "the opening of shoe \"shoe\" never passes over the cavity");
}

TEST(Setup, APunchBesideTheCavityIsTold) {
  const SmallDie die;
  die.add_tool("punch", "punch", cad::prism(cad::rectangle(0, 2, 0, 2), -9, -6),
               "[\"1 mm\", \"0 mm\", \"0 mm\"]");
  expect_says(die.check().out, "punch \"punch\" is beside the cavity");
}

/// A die whose hole goes through, and what else closes it.
class ThroughDie : public SmallDie {
 public:
  ThroughDie() {
    write("die.stl", cad::binary_stl(
                         cad::tube(cad::rectangle(-15, 6, -3.5, 3.5), cad::rectangle(-5, -1, -2, 2), -5, 0)));
  }
};

cad::Part punch_to(double top) {
  return cad::prism(cad::rectangle(-4.98, -1.02, -1.98, 1.98), top - 3, top);
}

TEST(NoCavity, ForWantOfAPunch) {
  const ThroughDie die;
  expect_refused(
      die,
      "found no cavity below the fill plane to pass over: nothing closes the die from below: it has a "
      "through hole of 4 x 4 mm, and no tool is a punch");
}

TEST(NoCavity, WithAPunchTooLow) {
  const ThroughDie die;
  die.add_tool("punch", "punch", punch_to(-7), "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  expect_refused(die,
                 "punch \"punch\" is too low: its top is at z = -7 mm, 2 mm below the die, which is at z = "
                 "-5 to 0 mm");
}

TEST(NoCavity, WithAPunchThatFillsTheHole) {
  for (const double top : {0.0, 1.0}) {
    const ThroughDie die;
    die.add_tool("punch", "punch", punch_to(top), "[\"0 mm\", \"0 mm\", \"0 mm\"]");
    expect_refused(die, "punch \"punch\" fills the hole: its top is at z = ");
  }
}

TEST(NoCavity, WithAPunchLiftedOutOfTheDie) {
  for (const auto& [top, above] :
       {std::pair{3.0, "0 mm above the top of the die at z = 0 mm"}, {5.5, "2.5 mm above"}}) {
    const ThroughDie die;
    die.add_tool("punch", "punch", punch_to(top), "[\"0 mm\", \"0 mm\", \"0 mm\"]");
    expect_refused(die, "punch \"punch\" stands above the die: it is at z = ");
    expect_refused(die, above);
  }
}

TEST(NoCavity, WithACoreLiftedOutOfTheDie) {
  const ThroughDie die;
  die.add_tool("punch", "punch",
               cad::tube(cad::rectangle(-4.98, -1.02, -1.98, 1.98), cad::rectangle(-4, -2, -1, 1), -7, -4),
               "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  die.add_tool("core", "core", cad::prism(cad::rectangle(-3.98, -2.02, -0.98, 0.98), -7, 0),
               "[\"0 mm\", \"0 mm\", \"8 mm\"]");
  expect_refused(
      die, "core \"core\" stands above the die: it is at z = 1 to 8 mm, its lower end 1 mm above the top");
}

/// Walls of the die on three sides above a pocket that is closed up to z = -2 mm.
TEST(NoCavity, ForAnOpenSide) {
  const SmallDie die;
  const auto wall = [](double lower_x, double upper_x, double lower_y, double upper_y) {
    return cad::prism(cad::rectangle(lower_x, upper_x, lower_y, upper_y), -2, 0);
  };
  die.write("die.stl", cad::binary_stl(wall(-15, 6, 2, 3.5)));
  die.add_tool("front", "die", wall(-15, 6, -3.5, -2), "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  die.add_tool("end", "die", wall(-1, 6, -2, 2), "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  die.add_tool(
      "bottom", "die",
      cad::block_with_pocket(cad::rectangle(-15, 6, -3.5, 3.5), cad::rectangle(-5, -1, -2, 2), -5, -4, -2),
      "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  expect_refused(die, "is open at the side near x = -1");
  expect_refused(die, "from z = -2 mm up, below the fill plane at z = 0 mm");
}

TEST(NoCavity, WithAPunchInInches) {
  const ThroughDie die;
  cad::Part punch = punch_to(-4);
  for (auto& triangle : punch)
    for (auto& corner : triangle)
      for (double& x : corner) x /= 25.4;
  die.add_tool("punch", "punch", punch, "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  die.exchange("file = \"punch.stl\"", "file = \"punch.stl\"\nsphere_radius = \"0.03 mm\"");
  expect_refused(
      die,
      "too small for the other tools by a factor of 25.4: its file seems to be in inch; write length_unit = "
      "\"inch\"");
}

TEST(NoCavity, InMachineCoordinates) {
  const SmallDie die;
  die.exchange("[measure]\n", "[measure]\nfill_plane = \"200 mm\"\n");
  expect_refused(die, "measure.fill_plane is 200 mm, but die \"die\" is at z = -5 to 0 mm");
}

cad::Part turned(cad::Part part, bool upside_down) {
  for (auto& triangle : part)
    for (auto& [x, y, z] : triangle) {
      const double old = y;
      y = upside_down ? -y : z;
      z = upside_down ? -z : -old;
    }
  return part;
}

TEST(NoCavity, WithAnotherAxisUp) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(cad::moved(turned(small_die(), false), {0, 0, -3.5})));
  expect_refused(die, "drawn with y up: a rotation by 90 deg about x gives a cavity");
  die.write("die.stl", cad::binary_stl(cad::moved(turned(small_die(), true), {0, 0, -5})));
  expect_refused(die, "drawn upside down: a rotation by 180 deg about x gives a cavity");
}

}  // namespace
}  // namespace diefill::app
