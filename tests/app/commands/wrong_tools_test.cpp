// Wrong inputs that show only once the CAD is read and stands in the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

struct WrongTool {
  std::string name;
  std::function<void(const SmallDie&)> spoil;
  std::vector<std::string> expected;  ///< all must stand in the message
};

std::ostream& operator<<(std::ostream& stream, const WrongTool& wrong) {
  return stream << wrong.name;
}

std::function<void(const SmallDie&)> with_file(const std::string& name, const std::string& bytes) {
  return [=](const SmallDie& die) { die.write(name, bytes); };
}

std::function<void(const SmallDie&)> with_die(const cad::Part& part) {
  return with_file("die.stl", cad::binary_stl(part));
}

std::function<void(const SmallDie&)> with_scene(const std::string& old, const std::string& text) {
  return [=](const SmallDie& die) { die.exchange(old, text); };
}

cad::Part with_a_hole() {
  cad::Part part = small_die();
  part.pop_back();
  return part;
}

cad::Part crossing_itself() {
  const cad::Part block = cad::prism(cad::rectangle(-15, 6, -3.5, 3.5), -5, 0);
  return cad::joined(block, cad::moved(block, {1.3, 0.7, -0.4}));
}

cad::Part with_a_corner_that_is_no_number() {
  cad::Part part = small_die();
  part[3][1][0] = std::nan("");
  return part;
}

cad::Part flat_plate() {
  return cad::prism(cad::rectangle(-15, 6, -3.5, 3.5), -5, 0);
}

cad::Part thin_shoe() {
  return cad::tube(cad::rectangle(-2.8, 2.8, -2.8, 2.8), cad::rectangle(-2.5, 2.5, -2.5, 2.5), 0, 10);
}

/// One of its walls is `thickness` (mm) thick, the others are over a millimetre.
cad::Part shoe_with_a_wall_of(double thickness) {
  return cad::tube(cad::rectangle(-4, 2.5 + thickness, -4, 4), cad::rectangle(-2.5, 2.5, -2.5, 2.5), 0, 10);
}

const std::string kDieFile = "file = \"die.stl\"", kNumerics = "[numerics]";
const std::string kPour =
    "from = [\"0.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]";

const std::string kHere = "[\"0 mm\", \"0 mm\", \"0 mm\"]";

/// No corner of one lies in the other.
void add_rod_through_a_punch(const SmallDie& die) {
  die.add_tool("punch", "punch", cad::prism(cad::rectangle(-4.9, -1.1, -1.9, 1.9), -12, -6), kHere);
  die.add_tool("rod", "core", cad::prism(cad::rectangle(-3.5, -2.5, -0.5, 0.5), -14, -5), kHere);
}

std::vector<WrongTool> wrong_files() {
  const std::string stl = cad::binary_stl(small_die());
  return {
      {"missing",
       [](const SmallDie& die) { std::filesystem::remove(die.folder() / "die.stl"); },
       {"scene.toml:16:8: tool.file", "found \"die.stl\"", "no such file"}},
      {"empty", with_file("die.stl", ""), {"die.stl"}},
      {"letter_called_stl",
       with_file("die.stl", "Dear Sir,\nenclosed is the drawing of the die.\n"),
       {"die.stl"}},
      {"picture_called_stl", with_file("die.stl", "\x89PNG\r\n\x1a\n" + std::string(400, 'x')), {"die.stl"}},
      {"cut_short", with_file("die.stl", stl.substr(0, stl.size() - 70)), {"die.stl"}},
      {"cut_in_the_header", with_file("die.stl", stl.substr(0, 60)), {"die.stl"}},
      {"corner_no_number", with_die(with_a_corner_that_is_no_number()), {"die.stl"}},
      {"text_cut_short", with_file("die.stl", cad::text_stl(small_die()).substr(0, 1000)), {"die.stl"}},
      {"without_triangles", with_file("die.stl", "solid part\nendsolid part\n"), {"die.stl"}},
  };
}

/// The die with that mesh, and nothing may be done about it.
std::function<void(const SmallDie&)> with_unrepaired_die(const cad::Part& part) {
  return [=](const SmallDie& die) {
    die.write("die.stl", cad::binary_stl(part));
    die.exchange(kDieFile, kDieFile + "\nrepair = \"off\"");
  };
}

std::vector<WrongTool> wrong_meshes() {
  return {
      {"open",
       with_unrepaired_die(with_a_hole()),
       {"scene.toml:13: tool \"die\"", "die.stl does not enclose a solid", "open edges"}},
      {"inside_out", with_unrepaired_die(cad::inside_out(small_die())), {"tool \"die\"", "inside out"}},
      {"crosses_itself", with_unrepaired_die(crossing_itself()), {"tool \"die\"", "cross"}},
      {"hole_that_may_be_an_opening",
       with_die(with_a_hole()),
       {"tool \"die\"", "open edges", "not repaired: a hole of", "may be an opening"}},
      {"part_that_is_not_there",
       with_scene(kDieFile, kDieFile + "\npart = \"dye\""),
       {"tool \"die\"", "has no part \"dye\": it contains \"", "use one of these names"}},
      {"thinner_than_wall_spheres",
       with_file("shoe.stl", cad::binary_stl(thin_shoe())),
       {"scene.toml:19: tool \"shoe\"", "0.3 mm thick",
        "wall sphere of 0.5 mm diameter: thicken the part, or reduce sphere_radius below 0.15 mm, or set "
        "walls = \"mesh\" for this tool"}},
      {"far_thinner_than_wall_spheres_may_be",
       with_file("shoe.stl", cad::binary_stl(shoe_with_a_wall_of(1.0 / 1024))),
       {"0.0009766 mm thick", "diameter: thicken the part, or set walls = \"mesh\" for this tool"}},
      {"unit_of_the_file_too_small",
       with_scene("length_unit = \"mm\"", "length_unit = \"um\""),
       {"tool \"die\""}},
      {"unit_of_the_file_too_large",
       with_scene("length_unit = \"mm\"", "length_unit = \"m\""),
       {"tool \"die\""}},
  };
}

std::vector<WrongTool> wrong_arrangements() {
  return {
      {"pour_box_reaches_into_the_shoe",
       with_scene("[\"5.5 mm\"", "[\"6 mm\""),
       {"scene.toml:26: pour", "tool \"shoe\" reaches", "into the powder"}},
      {"powder_beside_every_tool",
       with_scene(kPour, "from = [\"20 mm\", \"-2 mm\", \"0 mm\"]\nto = [\"24 mm\", \"2 mm\", \"9 mm\"]"),
       {"scene.toml:26: pour"}},
      {"powder_partly_over_nothing",
       with_scene(kPour, "from = [\"6.8 mm\", \"-2 mm\", \"0 mm\"]\nto = [\"11 mm\", \"2 mm\", \"9 mm\"]"),
       {"scene.toml:26: pour"}},
      {"powder_below_the_tools",
       with_scene(kPour,
                  "from = [\"0.5 mm\", \"-2.5 mm\", \"-30 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"-15 mm\"]"),
       {"scene.toml:26: pour"}},
      {"shoe_stands_in_the_die",
       with_scene("\"0 mm\", \"0 mm\"]\n\n[pour]", "\"0 mm\", \"-2 mm\"]\n\n[pour]"),
       {"tool \"shoe\"", "tool \"die\""}},
      {"rod_through_a_solid_punch",
       add_rod_through_a_punch,
       {"tool \"rod\"", "tool \"punch\"", "overlap by"}},
      {"punch_wider_than_its_bore",
       [](const SmallDie& die) {
         die.add_tool("punch", "punch", cad::prism(cad::rectangle(-5.8, -0.2, -2.8, 2.8), -9, -1), kHere);
       },
       {"tool \"punch\"", "tool \"die\"", "overlap by"}},
      {"wall_spheres_too_far_apart",
       with_scene("position =", "sphere_radius = \"0.28 mm\"\nspacing = 4\nposition ="),
       {"tool.spacing", "found 4", "through"}},
      {"no_cavity_and_no_travel", with_die(flat_plate()), {"scene.toml:", "no cavity", "travel = \"60 mm\""}},
      {"shoe_past_the_cavity",
       with_scene("direction = \"-x\"", "direction = \"+x\""),
       {"\"shoe\" already beyond the cavity"}},
      {"nothing_stands",
       with_scene("role = \"die\"", "role = \"shoe\""),
       {"no die or plate to pour powder on"}},
      {"period_across_a_pocket",
       with_scene(kNumerics, "[numerics]\nperiodic = { y = \"5 mm\" }"),
       {"tool \"die\"", "not uniform along y"}},
      {"period_longer_than_the_die",
       with_scene(kNumerics, "[numerics]\nperiodic = { y = \"9 mm\" }"),
       {"tool \"die\"", "shorter along y than the period"}},
      {"time_step_above_the_critical",
       with_scene("time_step_fraction = 0.15", "time_step = \"0.9 ms\""),
       {"numerics.time_step", "0.0009 s", "above the critical step"}},
      {"box_narrower_than_a_loose_grain",
       with_scene(kPour, "from = [\"2 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"3.1 mm\", \"2.5 mm\", \"9 mm\"]"),
       {"scene.toml:26: pour", "narrower than a grain"}},
      {"not_even_one_grain",
       with_scene("fill_height = \"5 mm\"", "fill_height = \"1 um\""),
       {"scene.toml:26: pour.fill_height", "does not hold a single grain"}},
  };
}

class WrongTools : public testing::TestWithParam<WrongTool> {};

TEST_P(WrongTools, EndInOneLineAndWriteNothing) {
  const SmallDie die;
  GetParam().spoil(die);
  const auto files_before = SmallDie::files_in(die.folder());
  const Outcome outcome = run_program({"check", die.scene().string()}, {die.folder(), {}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  for (const std::string& part : GetParam().expected)
    EXPECT_NE(outcome.err.find(part), std::string::npos)
        << "missing: " << part << "\nin:      " << outcome.err;
  EXPECT_EQ(SmallDie::files_in(die.folder()), files_before);
}

TEST(WrongMeshWalls, AreNotToldToBecomeMeshWalls) {
  const SmallDie die;
  die.write("shoe.stl", cad::binary_stl(shoe_with_a_wall_of(0.01)));
  die.exchange("role = \"shoe\"", "role = \"shoe\"\nwalls = \"mesh\"");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("thicken the part, or reduce sphere_radius below 0.005 mm"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("walls ="), std::string::npos) << outcome.err;
}

std::string name_of(const testing::TestParamInfo<WrongTool>& instance) {
  return instance.param.name;
}

INSTANTIATE_TEST_SUITE_P(File, WrongTools, testing::ValuesIn(wrong_files()), name_of);
INSTANTIATE_TEST_SUITE_P(Mesh, WrongTools, testing::ValuesIn(wrong_meshes()), name_of);
INSTANTIATE_TEST_SUITE_P(Arrangement, WrongTools, testing::ValuesIn(wrong_arrangements()), name_of);

}  // namespace
}  // namespace diefill::app
