// AMF files: where constellations place objects, and files that are packed.
#include "geometry/cad/amf_document.h"

#include <gtest/gtest.h>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_check.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

using support::TemporaryFolder;

/// A block of 1 x 2 x 3 mm with a corner in the origin, object 0 of the file, and what follows it there.
std::string block_and(const std::string& more) {
  std::string text = sample::amf(sample::box({0, 0, 0}, {1, 2, 3}), "millimeter");
  return text.insert(text.find("</amf>"), more);
}

/// mm, of the block as the file places it.
Box placed_by(const std::string& constellations) {
  const TemporaryFolder directory;
  const ImportedPart part = import_part(directory.write("block.amf", block_and(constellations)), {});
  EXPECT_TRUE(check_mesh(part.mesh).usable());
  EXPECT_NEAR(part.mesh.volume(), 6e-9 * static_cast<double>(part.parts.size()), 1e-14);
  Box box = part.mesh.bounding_box();
  box.lower *= 1e3, box.upper *= 1e3;
  return box;
}

void expect_box(const Box& box, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  EXPECT_LT((box.lower - lower).norm(), 1e-5) << box.lower.transpose();
  EXPECT_LT((box.upper - upper).norm(), 1e-5) << box.upper.transpose();
}

std::string complaint_about(const std::string& file, const std::string& bytes) {
  const TemporaryFolder directory;
  try {
    import_part(directory.write(file, bytes), {});
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

void expect_says(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words << "\nin: " << text;
}

TEST(AmfConstellations, ShiftObjects) {
  expect_box(
      placed_by("<constellation id=\"9\"><instance objectid=\"0\"><deltax>10</deltax><deltay> -5 </deltay>"
                "<deltaz>0.5</deltaz></instance></constellation>"),
      {10, -5, 0.5}, {11, -3, 3.5});
}

TEST(AmfConstellations, TurnByDegreesBeforeTheyShift) {
  expect_box(
      placed_by("<constellation id=\"9\"><instance objectid=\"0\"><deltax>10</deltax><deltay>20</deltay>"
                "<deltaz>-500</deltaz><rx>0</rx><ry>0</ry><rz>90</rz></instance></constellation>"),
      {8, 20, -500}, {10, 21, -497});
}

TEST(AmfConstellations, TurnAboutXThenYThenZ) {
  // About x: y is z. About y: z is x. About z: x is y. The sides 1, 2, 3 end along z, y... as below.
  expect_box(
      placed_by(
          "<constellation id=\"9\"><instance objectid=\"0\"><rx>90</rx><ry>90</ry><rz>90</rz></instance>"
          "</constellation>"),
      {0, 0, -1}, {3, 2, 0});
}

TEST(AmfConstellations, PlaceAnObjectAsOftenAsTheySay) {
  const std::string twice =
      "<constellation id=\"9\"><instance objectid=\"0\"><deltax>0</deltax></instance>"
      "<instance objectid=\"0\"><deltax>100</deltax></instance></constellation>";
  expect_box(placed_by(twice), {0, 0, 0}, {101, 2, 3});
  const TemporaryFolder directory;
  ImportOptions options;
  options.part = "0 (2)";
  const ImportedPart second = import_part(directory.write("two.amf", block_and(twice)), options);
  EXPECT_EQ(second.parts, (std::vector<std::string>{"0 (1)", "0 (2)"}));
  EXPECT_NEAR(second.mesh.bounding_box().lower.x(), 0.1, 1e-8);
  options.part = "9";  // all that is in the constellation
  EXPECT_NEAR(import_part(directory.path() / "two.amf", options).mesh.volume(), 12e-9, 1e-14);
}

TEST(AmfConstellations, MultiplyWhereTheyContainEachOther) {
  expect_box(
      placed_by(
          "<constellation id=\"7\"><instance objectid=\"9\"><deltax>10</deltax><rz>90</rz></instance>"
          "</constellation><!-- <instance objectid=\"0\"> -->"
          "<constellation id=\"9\"><instance objectid=\"0\"><deltay>5</deltay></instance></constellation>"),
      {3, 0, 0}, {5, 1, 3});
}

TEST(AmfConstellations, LeaveOtherObjectsWhereTheyAreDrawn) {
  expect_box(placed_by("<constellation id=\"9\"/>"), {0, 0, 0}, {1, 2, 3});
}

TEST(AmfConstellations, OfNothingOrWithoutEndAreRefused) {
  const auto instance = [](const std::string& id, const std::string& of, const std::string& shift) {
    return "<constellation id=\"" + id + "\"><instance objectid=\"" + of + "\"><deltax>" + shift +
           "</deltax></instance></constellation>";
  };
  expect_says(complaint_about("a.amf", block_and(instance("9", "5", "0"))),
              "its constellation '9' places object '5', which is not in the file");
  expect_says(complaint_about("a.amf", block_and(instance("9", "9", "0"))), "contain each other without end");
  expect_says(complaint_about("a.amf", block_and(instance("8", "9", "0") + instance("9", "8", "0"))),
              "contain each other without end");
  expect_says(complaint_about("a.amf", block_and(instance("9", "0", "1,5"))),
              "an instance needs numbers, found deltax = '1,5' with a comma");
}

TEST(AmfArchive, IsUnpacked) {
  const TemporaryFolder directory;
  const std::string plain = block_and("");
  const ImportedPart part = import_part(
      directory.write("packed.amf", sample::zip({{"readme.txt", "x"}, {"Block.AMF", plain}})), {});
  EXPECT_NEAR(part.mesh.volume(), 6e-9, 1e-14);
  EXPECT_DOUBLE_EQ(part.metres_per_unit, 1e-3);
}

TEST(AmfArchive, WithoutAmfOrDamagedIsToldAsOne) {
  expect_says(complaint_about("a.amf", sample::zip({{"block.stl", "x"}})),
              "it is a ZIP archive that holds no .amf file");
  std::string damaged = sample::zip({{"block.amf", block_and("")}});
  damaged[damaged.find("<x>1")] = 'X';
  expect_says(complaint_about("a.amf", damaged), "its ZIP archive is damaged");
}

}  // namespace
}  // namespace diefill::geometry
