#include "render/scene3d/solid_mesh_vtu.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace diefill::render {
namespace {

results::SolidMesh two_tetrahedra() {
  results::SolidMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1e-3}, {1e-3, 1e-3, 1e-3}};
  mesh.node_numbers = {1, 2, 3, 5, 9};
  mesh.elements = {{results::ElementShape::tetra4, 7, {0, 1, 2, 3}},
                   {results::ElementShape::tetra4, 8, {1, 4, 2, 3}}};
  return mesh;
}

TEST(SolidMeshVtu, GivesTheMeshBack) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "a.vtu";
  write_vtu(file, two_tetrahedra(), {{"f", 1, {1, 2, 3, 4, 5}}}, {{"g", 1, {0.25, 0.5}}});
  const auto mesh = read_vtu(file, 1e3);
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(mesh.nodes[4], Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(mesh.elements[1].nodes[1], 4U);
  EXPECT_EQ(mesh.elements[1].number, 1U);  // as ParaView counts
  EXPECT_NE(support::contents(file).find("\"number\""), std::string::npos);
}

std::string refusal(const std::filesystem::path& file) {
  try {
    read_vtu(file, 1);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

TEST(SolidMeshVtu, BadFilesAreRefusedWithTheReason) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "a.vtu";
  EXPECT_EQ(refusal(file), "found no such file");
  folder.write("a.vtu", "solid\n");
  EXPECT_EQ(refusal(file), "found a file that is not in VTK format, expected an UnstructuredGrid (.vtu)");
  write_points(file, {{0, 0, 0}}, {});
  EXPECT_EQ(refusal(file), "found VTK data of type PolyData, expected an UnstructuredGrid (.vtu)");
  write_vtu(file, two_tetrahedra(), {}, {});
  const std::string whole = support::contents(file);
  folder.write("a.vtu", whole.substr(0, whole.size() / 2));
  // VTK says nothing itself, wherever the file is cut.
  for (const std::size_t share : {2U, 3U, 5U, 10U}) {
    folder.write("a.vtu", whole.substr(0, whole.size() / share));
    testing::internal::CaptureStderr();
    EXPECT_NE(refusal(file), "read");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

TEST(SolidMeshVtu, MorePointsThanTheFileCanHoldAreRefusedInOneLine) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "a.vtu";
  write_vtu(file, two_tetrahedra(), {}, {});
  std::string text = support::contents(file);
  const std::string points = "NumberOfPoints=\"5\"";
  ASSERT_NE(text.find(points), std::string::npos);
  folder.write("a.vtu", text.replace(text.find(points), points.size(), "NumberOfPoints=\"99999999999\""));
  testing::internal::CaptureStderr();
  const std::string message = refusal(file);
  EXPECT_EQ(message.find("declares NumberOfPoints=\"99999999999\", more than its "), 0U) << message;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace diefill::render
