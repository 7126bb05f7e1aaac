// Tools as CAD programs write them: whatever the file is like, the cavity and the powder are those of the
// same tools written plainly, or one line says what to do.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <sstream>

#include "project_paths.h"
#include "tests/app/small_die.h"
#include "tests/geometry/mesh_files.h"

namespace diefill::app {
namespace {

const std::string kMm = "\nlength_unit = \"mm\"";

void expect_says(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words << "\nin: " << text;
}

/// What `check` finds; nothing where it refuses the scene.
nlohmann::json checked(const SmallDie& die) {
  const Outcome outcome = run_program({"check", die.scene().string(), "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.exit_code == 0 ? nlohmann::json::parse(outcome.out) : nlohmann::json();
}

/// The same cavity and the same grains as the tools written plainly; gives what was found.
nlohmann::json expect_as_plain(const SmallDie& die) {
  static const nlohmann::json plain = checked(SmallDie());
  const nlohmann::json found = checked(die);
  if (found.is_null() || plain.is_null()) return found;
  const double volume = plain.at("cavity").at("volume_m3");
  EXPECT_NEAR(volume, 64e-9, 1e-15);
  EXPECT_NEAR(found.at("cavity").at("volume_m3"), volume, 1e-6 * volume);
  EXPECT_GT(plain.at("simulation").at("grains"), 50);
  EXPECT_EQ(found.at("simulation").at("grains"), plain.at("simulation").at("grains"));
  return found;
}

/// Refused in one line that holds all `words`.
void expect_refused(const SmallDie& die, const std::vector<std::string>& words) {
  const Outcome outcome = run_program({"check", die.scene().string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_LT(outcome.err.size(), 800U) << outcome.err;
  for (const std::string& word : words) expect_says(outcome.err, word);
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
  return text;
}

std::string in_capitals_with_exponents(const cad::Part& part) {
  std::string text = "SOLID DIE\n";
  for (const cad::Triangle& triangle : part) {
    text += "  FACET NORMAL 0.00000000E+00 0.00000000E+00 1.00000000E+00\n    OUTER LOOP\n";
    for (const cad::Point& point : triangle) {
      char line[100];
      std::snprintf(line, sizeof line, "      VERTEX %+.8E %+.8E %+.8E\n", point[0], point[1], point[2]);
      text += line;
    }
    text += "    ENDLOOP\n  ENDFACET\n";
  }
  return text + "ENDSOLID DIE\n";
}

cad::Part scaled(cad::Part part, double factor) {
  for (cad::Triangle& triangle : part)
    for (cad::Point& point : triangle)
      for (double& value : point) value *= factor;
  return part;
}

TEST(CadAsItComes, TextStlInCapitalsWithExponents) {
  const SmallDie die;
  die.write("die.stl", in_capitals_with_exponents(small_die()));
  expect_as_plain(die);
}

TEST(CadAsItComes, FacetNormalsNeedNotBeNumbers) {
  const SmallDie die;
  for (const char* normal :
       {"nan nan nan", "-nan(ind) -nan(ind) -nan(ind)", "-1.#IND00 -1.#IND00 -1.#IND00", "0 0 0"}) {
    SCOPED_TRACE(normal);
    die.write("die.stl",
              replaced(cad::text_stl(small_die()), "normal 0 0 0", std::string("normal ") + normal));
    expect_as_plain(die);
  }
}

TEST(CadAsItComes, ABinaryStlMayBeginWithSolidAndCarryColours) {
  const SmallDie die;
  std::string bytes = cad::binary_stl(small_die());
  bytes.replace(0, 29, "solid exported with COLOR=abc");
  for (std::size_t at = 84 + 48; at < bytes.size(); at += 50) bytes[at] = '\x1f', bytes[at + 1] = '\x80';
  die.write("die.stl", bytes);
  expect_as_plain(die);
}

TEST(CadAsItComes, BytesBehindTheLastTriangleAreRemarkedOn) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(small_die()) + std::string(317, '\0') + "trailer");
  const auto found = expect_as_plain(die);
  const std::string remark = "324 bytes after the last triangle ignored";
  EXPECT_EQ(found["tools"][0]["file_remarks"], nlohmann::json::array({remark}));
  EXPECT_TRUE(found["tools"][0]["repairs"].empty());
  const Outcome outcome = die.check();
  expect_says(outcome.out, "\n  file: " + remark + "\n");
  expect_says(outcome.out, "note: tool \"die\": " + remark);
  EXPECT_EQ(outcome.out.find("repaired: "), std::string::npos) << outcome.out;
}

TEST(CadAsItComes, ABinaryStlOfNoTrianglesIsRefused) {
  const SmallDie die;
  die.write("die.stl", std::string(80, ' ') + std::string(4, '\0'));
  expect_refused(die,
                 {"die.stl' holds no triangles: its header counts none, and nothing follows it; export"});
  die.write("die.stl", std::string(80, ' ') + std::string(11, '\0'));
  expect_refused(die,
                 {"counts none, and the 7 bytes after it are not a whole number of triangles of 50 bytes"});
}

/// A punch below the die and one far above it, in one file.
void write_two_punches(const SmallDie& die, const std::string& part) {
  const cad::Outline outline = cad::rectangle(-15, 6, -3.5, 3.5);
  const auto solid = [](const cad::Part& shape, const std::string& name) {
    return replaced(cad::text_stl(shape), "solid part", "solid " + name);
  };
  die.add_tool("lower", "punch", cad::prism(outline, -8, -6), R"(["0 mm", "0 mm", "0 mm"])");
  die.write("punches.stl", solid(cad::prism(outline, -8, -6), "punch lower") +
                               solid(cad::prism(outline, 30, 32), "punch upper"));
  die.exchange("file = \"lower.stl\"", "file = \"punches.stl\"\npart = \"" + part + "\"");
}

TEST(CadAsItComes, SolidsAreFoundByTheirWholeNames) {
  const SmallDie die;
  write_two_punches(die, "punch lower");
  const auto found = expect_as_plain(die);
  EXPECT_NEAR(found["tools"][2]["upper_corner_m"][2], -6e-3, 1e-9);
}

TEST(CadAsItComes, AShortNameOfTwoSolidsIsRefusedWithTheList) {
  const SmallDie die;
  write_two_punches(die, "punch");
  expect_refused(die, {"tool \"lower\"", "part \"punch\" matches several: \"punch lower\" around (",
                       "\"punch upper\" around (", "write the full name"});
}

TEST(CadAsItComes, MachineCoordinatesNineMetresAwayAreMovedBack) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(cad::moved(small_die(), {9000, -9000, 4000})));
  die.exchange("file = \"die.stl\"" + kMm,
               "file = \"die.stl\"" + kMm + "\nposition = [\"-9000 mm\", \"9000 mm\", \"-4000 mm\"]");
  expect_as_plain(die);
}

TEST(CadAsItComes, CoordinatesKilometresAwayHaveLostTheirDigits) {
  const SmallDie die;
  const cad::Part far = cad::moved(small_die(), {7502216, 5412342, 0});
  die.write("die.stl", cad::binary_stl(far));
  expect_refused(die, {"tool \"die\"", "from the origin", "which distorts its shape",
                       "move it to the origin in CAD and export it again"});
  die.write("die.stl", in_capitals_with_exponents(far));
  expect_refused(
      die, {"tool \"die\": is ", "from the origin, allowed: up to 20 m", "move it to the origin in CAD"});
}

TEST(CadAsItComes, ACornerOnANeighboursEdgeSplitsIt) {
  const SmallDie die;
  cad::Part part = small_die();
  const cad::Triangle old = part[0];
  cad::Point middle;
  for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = (old[0][axis] + old[1][axis]) / 2;
  part[0] = {old[0], middle, old[2]};
  part.push_back({middle, old[1], old[2]});
  die.write("die.stl", cad::binary_stl(part));
  expect_says(expect_as_plain(die)["tools"][0]["repairs"].dump(),
              "1 edge split where a corner of a neighbour lies on it");
}

TEST(CadAsItComes, DoubledFacetsAreDropped) {
  const SmallDie die;
  const cad::Part part = small_die();
  die.write("die.stl", cad::binary_stl(cad::joined(part, {part[0], part[5], part[5]})));
  expect_says(expect_as_plain(die)["tools"][0]["repairs"].dump(), "3 duplicate triangles removed");
}

TEST(CadAsItComes, BlocksThatShareAFaceAreOneDie) {
  const SmallDie die;
  const cad::Outline outer = cad::rectangle(-15, 6, -3.5, 3.5), pocket = cad::rectangle(-5, -1, -2, 2);
  die.write("die.stl",
            cad::binary_stl(cad::joined(cad::prism(outer, -5, -4), cad::tube(outer, pocket, -4, 0))));
  const auto found = expect_as_plain(die);
  EXPECT_EQ(found["tools"][0]["mesh"]["shells"], 1);
  EXPECT_EQ(found["tools"][0]["repairs"].size(), 1U) << found["tools"][0]["repairs"];
}

TEST(CadAsItComes, AnInchFileTakenForMillimetresIsToldSo) {
  const SmallDie die;
  die.write("die.stl", cad::binary_stl(scaled(small_die(), 1 / 25.4)));
  expect_refused(die, {"tool \"die\"", "21 mm in \"inch\""});
  die.exchange("file = \"die.stl\"" + kMm, "file = \"die.stl\"\nlength_unit = \"inch\"");
  expect_as_plain(die);
}

/// An object of a 3MF file, coordinates in inch.
std::string object_of_mesh(int id, const std::string& name, const cad::Part& part) {
  std::ostringstream vertices, triangles;
  vertices.precision(9);
  int corners = 0;
  for (const cad::Triangle& triangle : scaled(part, 1 / 25.4)) {
    for (const cad::Point& point : triangle)
      vertices << "<vertex x=\"" << point[0] << "\" y=\"" << point[1] << "\" z=\"" << point[2] << "\"/>";
    triangles << "<triangle v1=\"" << corners << "\" v2=\"" << corners + 1 << "\" v3=\"" << corners + 2
              << "\"/>";
    corners += 3;
  }
  return "<object id=\"" + std::to_string(id) + "\" name=\"" + name + "\" type=\"model\"><mesh><vertices>" +
         vertices.str() + "</vertices><triangles>" + triangles.str() + "</triangles></mesh></object>";
}

std::string object_of_components(int id, const std::string& name, const std::string& components) {
  return "<object id=\"" + std::to_string(id) + "\" name=\"" + name + "\" type=\"model\"><components>" +
         components + "</components></object>";
}

std::string component(int id, const std::string& transform) {
  return "<component objectid=\"" + std::to_string(id) + "\" transform=\"" + transform + "\"/>";
}

std::string archive_of(const std::string& objects, int built) {
  const std::string schemas = "http://schemas.openxmlformats.org/package/2006/";
  return geometry::sample::zip(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\"?><Types xmlns=\"" + schemas +
            "content-types\"><Default Extension=\"rels\" ContentType=\"application/"
            "vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
            "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels", "<?xml version=\"1.0\"?><Relationships xmlns=\"" + schemas +
                           "relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                           "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                           "</Relationships>"},
       {"3D/3dmodel.model",
        "<?xml version=\"1.0\"?><model unit=\"inch\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
            objects + "</resources><build><item objectid=\"" + std::to_string(built) +
            "\"/></build></model>"}});
}

/// A quarter turn to the right about the z axis.
cad::Part turned_back(cad::Part part) {
  for (cad::Triangle& triangle : part)
    for (cad::Point& point : triangle) point = {point[1], -point[0], point[2]};
  return part;
}

TEST(CadAsItComes, ComponentsWithinComponentsOf3mfInInchStandWhereTheFileSays) {
  const SmallDie die;
  // The die is turned left in the inner assembly, which the outer one moves by (1, 2, 0) inch.
  const cad::Part stored = turned_back(cad::moved(small_die(), {-25.4, -50.8, 0}));
  die.write("press.3mf",
            archive_of(object_of_mesh(1, "die", stored) + object_of_mesh(2, "shoe", small_shoe()) +
                           object_of_components(3, "press", component(1, "0 1 0 -1 0 0 0 0 1 0 0 0")) +
                           object_of_components(4, "assembly",
                                                component(3, "1 0 0 0 1 0 0 0 1 1 2 0") +
                                                    component(2, "1 0 0 0 1 0 0 0 1 0 0 0")),
                       4));
  die.exchange("file = \"die.stl\"" + kMm, "file = \"press.3mf\"\npart = \"die\"");
  die.exchange("file = \"shoe.stl\"" + kMm, "file = \"press.3mf\"\npart = \"shoe\"");
  const auto found = expect_as_plain(die);
  EXPECT_EQ(found["tools"][0]["parts_in_file"].size(), 2U) << found["tools"][0]["parts_in_file"];
  EXPECT_DOUBLE_EQ(found["tools"][0]["metres_per_unit"], 0.0254);
}

/// Writes nested.step and placed_twice.step into the die's folder (tests/step_files).
void write_step_files(const SmallDie& die) {
  const std::string program = std::filesystem::path(DIEFILL_PROGRAM).replace_filename("step_files").string();
  ASSERT_EQ(std::system(("'" + program + "' '" + die.folder().string() + "'").c_str()), 0);
}

TEST(CadAsItComes, NestedProductsOfStepStandWhereTheFileSays) {
  const SmallDie die;
  write_step_files(die);
  die.exchange("file = \"die.stl\"" + kMm, "file = \"nested.step\"\npart = \"die\"");
  die.exchange("file = \"shoe.stl\"" + kMm + "\nposition = [\"3 mm\", \"0 mm\", \"0 mm\"]",
               "file = \"nested.step\"\npart = \"shoe\"");
  expect_as_plain(die);
}

TEST(CadAsItComes, AProductThatStepPlacesTwiceIsAskedFor) {
  const SmallDie die;
  write_step_files(die);
  die.exchange("file = \"die.stl\"" + kMm, "file = \"placed_twice.step\"\npart = \"die\"");
  expect_refused(die, {"part \"die\" occurs more than once: \"die (1)\" around (-4.50, 0.00, -2.50) mm, "
                       "\"die (2)\" around (35.50, 0.00, -2.50) mm",
                       "write the full name"});
  die.exchange("part = \"die\"", "part = \"die (1)\"");
  expect_as_plain(die);
}

TEST(CadAsItComes, AMissingLibraryForStepIsAFaultOfTheInstallation) {
  const SmallDie die;
  write_step_files(die);
  die.exchange("file = \"die.stl\"" + kMm, "file = \"nested.step\"\npart = \"die\"");
  Surroundings elsewhere;
  elsewhere.program = die.folder() / "diefill";
  std::filesystem::copy_file(DIEFILL_PROGRAM, elsewhere.program);
  const Outcome outcome = run_program({"check", die.scene().string()}, elsewhere);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  expect_says(outcome.err, "tool \"die\"");
  expect_says(outcome.err, "libdiefill_opencascade.so");
  expect_says(outcome.err, "install diefill again, or export the parts as STL");
}

}  // namespace
}  // namespace diefill::app
