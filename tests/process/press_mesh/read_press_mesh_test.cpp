#include "process/press_mesh/read_press_mesh.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "project_paths.h"
#include "tests/process/press_mesh/sample_meshes.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

using Reader = results::SolidMesh (*)(const std::filesystem::path&, double);

results::SolidMesh read(Reader reader, const std::string& text, double unit = 1) {
  const support::TemporaryFolder folder;
  return reader(folder.write("mesh.txt", text), unit);
}

/// The message of a refusal, without the folder.
std::string refusal(Reader reader, const std::string& text) {
  try {
    read(reader, text);
  } catch (const SceneError& error) {
    const std::string message = error.what();
    return message.substr(message.find("mesh.txt"));
  }
  return "read";
}

TEST(PressMesh, OfGmshVersion2KeepsNumbersAndDropsWhatHasNoVolume) {
  const auto mesh = read(read_gmsh, gmsh22(), 1e-3);
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(mesh.elements[0].number, 7U);
  EXPECT_EQ(mesh.left_out, 2U);
  EXPECT_EQ(mesh.node_numbers, (std::vector<std::uint64_t>{1, 2, 3, 5, 9}));
  EXPECT_NEAR(volume_of(mesh, mesh.elements[0]), 1e-9 / 6, 1e-24);
  EXPECT_EQ(mesh.nodes[mesh.elements[1].nodes[1]], Eigen::Vector3d(1e-3, 1e-3, 0.5e-3));
}

TEST(PressMesh, OfGmshVersion4IsRead) {
  const auto mesh = read(read_gmsh, gmsh41());
  ASSERT_EQ(mesh.elements.size(), 1U);
  EXPECT_EQ(mesh.elements[0].number, 7U);
  EXPECT_EQ(mesh.left_out, 1U);
  EXPECT_NEAR(volume_of(mesh, mesh.elements[0]), 1.0 / 6, 1e-15);
}

TEST(PressMesh, OfAbaqusIsReadOverContinuedLines) {
  const auto mesh = read(read_inp, inp_cube(), 1e-3);
  ASSERT_EQ(mesh.elements.size(), 1U);
  EXPECT_EQ(mesh.elements[0].number, 11U);
  EXPECT_EQ(mesh.elements[0].shape, results::ElementShape::hexa8);
  EXPECT_EQ(mesh.left_out, 1U);
  EXPECT_NEAR(volume_of(mesh, mesh.elements[0]), 8e-9, 1e-20);
}

// The file that Gmsh itself wrote of the press part of two levels: 8 x 10 x (12 + 6) mm.
TEST(PressMesh, OfTheSampleHasThePartsVolume) {
  const auto file = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/stepped_part/stepped_part.msh";
  const auto mesh = read_gmsh(file, 1e-3);
  double volume = 0;
  for (const auto& element : mesh.elements) volume += results::volume_of(mesh, element);
  EXPECT_NEAR(volume, 1440e-9, 1e-15);
}

TEST(PressMesh, OfSecondOrderHasItsMiddleNodesInPlace) {
  // A tetrahedron of 10 nodes whose last two Gmsh has the other way round.
  const std::string nodes =
      "$Nodes\n10\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 0 0 2\n5 1 0 0\n6 1 1 0\n7 0 1 0\n8 0 0 1\n9 0 1 1\n10 1 0 "
      "1\n$EndNodes\n";
  const auto mesh = read(read_gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes +
                                        "$Elements\n1\n1 11 2 1 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n");
  EXPECT_NEAR(volume_of(mesh, mesh.elements[0]), 8.0 / 6, 1e-14);
  for (const auto& part : tetrahedra_of(mesh, mesh.elements[0])) EXPECT_LT(results::signed_volume(part), 0);
}

struct Wrong {
  Reader reader;
  std::string text, message;
};

TEST(PressMesh, OfAbaqusMayHaveNormalsAndCollapsedElements) {
  using support::exchanged;
  EXPECT_EQ(
      read(read_inp, exchanged(inp_cube(), "2, 2., 0., 0.", "2, 2., 0., 0., 0., 0.6, -0.8")).nodes.size(),
      8U);
  // A wedge as a hexahedron with two edges drawn together.
  const auto wedge =
      exchanged(exchanged(inp_cube(), "11, 1, 2, 3, 4", "11, 1, 2, 3, 3"), " 5, 6, 7, 8", " 5, 6, 7, 7");
  EXPECT_EQ(read(read_inp, wedge).elements.size(), 1U);
}

TEST(PressMesh, BadFilesAreRefusedInOneLineWithItsNumber) {
  using support::exchanged;
  const std::string tetra = "7 4 2 1 1 1 2 3 5", head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::vector<Wrong> all = {
      {read_gmsh, gmsh22("4.0 0 8"), "mesh.txt:2: found \"4.0 0 8\", expected version 2.2 or 4.1"},
      {read_gmsh, gmsh22("2.2 1 8"), "mesh.txt:2: found \"2.2 1 8\", expected a text file"},
      {read_gmsh, "solid\n", "mesh.txt:1: found \"solid\", expected $MeshFormat"},
      {read_gmsh, exchanged(gmsh22(), "9 1 1 0.5", "9 1 1 O.5"),
       "mesh.txt:14: found \"O.5\", expected a number"},
      {read_gmsh, exchanged(gmsh22(), "9 1 1 0.5", "5 1 1 0.5"), "mesh.txt:14: node 5 is defined twice"},
      {read_gmsh, exchanged(gmsh22(), tetra, "7 4 2 1 1 1 2 3 4"), "mesh.txt:21: element 7 has node 4"},
      {read_gmsh, exchanged(gmsh22(), tetra, "7 4 2 1 1 1 2 3"),
       "mesh.txt:21: element 7 has 3 nodes, expected 4"},
      {read_gmsh, exchanged(gmsh22(), tetra, "7 92 2 1 1 1 2 3 5"), "mesh.txt:21: element of type 92"},
      {read_gmsh, exchanged(gmsh22(), tetra, "8 4 2 1 1 1 2 3 5"), "mesh.txt: element 8 is defined twice"},
      {read_gmsh, exchanged(gmsh22(), tetra, "7 4 2 1 1 1 2 3 3"), "mesh.txt: element 7 has no volume"},
      {read_gmsh, gmsh22().substr(0, gmsh22().find("10 7")), "mesh.txt: the file ends after line 14"},
      {read_gmsh, head, "mesh.txt: found no element with volume"},
      {read_inp, "*INCLUDE, INPUT=other.inp\n", "mesh.txt:1: found \"*INCLUDE, INPUT=other.inp\""},
      {read_inp, "*Part, name=a\n", "mesh.txt:1: found \"*Part, name=a\", expected a flat file"},
      {read_inp, "*NODE\n1, 0, 0\n", "mesh.txt:2: found \"1, 0, 0\", expected a node: number, x, y, z"},
      {read_inp, exchanged(inp_cube(), "C3D8R", "C3D27"), "mesh.txt:14: found TYPE=C3D27"},
      {read_inp, exchanged(inp_cube(), "4,\n 5, 6", "4,\n 5"),
       "mesh.txt:16: element with 7 nodes, expected 8"},
      {read_inp, exchanged(inp_cube(), "2, 2., 0., 0.", "2, 2,5, 0., 0."),
       "mesh.txt:6: found \"2, 2,5, 0., 0.\", expected a node: number, x, y, z, with decimal points"},
      {read_inp, exchanged(inp_cube(), "2, 2., 0., 0.", "2, 2,0, 0,0, 9,0"),
       "mesh.txt:6: found \"2, 2,0, 0,0, 9,0\", expected a node"},
      {read_inp, exchanged(inp_cube(), "2, 2., 0., 0.", "2, 1e999, 0., 0."),
       "mesh.txt:6: found \"1e999\", a number that is too large"},
      {read_inp, std::string("\xFF\xFE*\0N\0", 6), "mesh.txt:1: found UTF-16 text, expected UTF-8"},
      {read_inp, exchanged(inp_cube(), "11, 1, 2, 3, 4", "11, 1, 3, 2, 4"),
       "mesh.txt: element 11 is twisted: the Jacobian is negative at"},
      {read_inp, exchanged(inp_cube(), "1, 2, 3, 4,\n 5, 6, 7, 8", "5, 6, 7, 8,\n 1, 2, 3, 4"),
       "mesh.txt: element 11 is inside out: the Jacobian is negative at all its corners"},
      {read_gmsh, exchanged(gmsh22(), tetra, "7 4 2 1 1 1 3 2 5"), "mesh.txt: element 7 is inside out"},
      {read_inp, exchanged(inp_cube(), "4, 0., 2., 0.", "4, 0., 2., nan"), "mesh.txt:8: found \"nan\""},
  };
  for (const auto& wrong : all)
    EXPECT_EQ(refusal(wrong.reader, wrong.text).substr(0, wrong.message.size()), wrong.message);
  EXPECT_THROW(read_gmsh("/no/such/file.msh", 1), SceneError);
}

}  // namespace
}  // namespace diefill::process
