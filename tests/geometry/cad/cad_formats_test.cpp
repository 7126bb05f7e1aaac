// Every kind of CAD file gives the same solid, with its parts' names, its unit, and z up.
#include <gtest/gtest.h>

#include "geometry/cad/cad_parts.h"
#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_check.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

using support::TemporaryFolder;

Mesh scaled(Mesh mesh, double factor) {
  for (auto& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

Mesh standing_tube() {
  return transformed(sample::tube(8, 12, 10, 90), Eigen::Matrix3d::Identity(), {30, 20, 5});
}

struct FileOfAFormat {
  std::string name, bytes;
  double stated_unit;  ///< m; 0 where the file cannot state one
};

std::vector<FileOfAFormat> tube_in_every_format() {
  const Mesh tube = standing_tube();
  return {{"text.stl", sample::ascii_stl(tube), 0},
          {"binary.STL", sample::binary_stl(tube), 0},
          {"tube.obj", sample::obj(tube), 0},
          {"tube.ply", sample::ply(tube), 0},
          {"binary.ply", sample::binary_ply(tube), 0},
          {"tube.off", sample::off(tube), 0},
          {"tube.amf", sample::amf(tube, "millimeter"), 1e-3},
          {"inch.amf", sample::amf(scaled(tube, 1 / 25.4), "inch"), 0.0254},
          {"tube.3mf", sample::three_mf({{"tube", tube}}, "millimeter"), 1e-3},
          {"inch.3mf", sample::three_mf({{"tube", scaled(tube, 1 / 25.4)}}, "inch"), 0.0254},
          {"tube.dae", sample::collada(tube, 1e-3), 1},
          {"metres.dae", sample::collada(scaled(tube, 1e-3), 1), 1},
          {"tube.gltf", sample::gltf(scaled(tube, 1e-3), "tube"), 1},
          {"tube.glb", sample::glb(scaled(tube, 1e-3), "tube"), 1}};
}

TEST(CadFormats, AllGiveTheSameTube) {
  const TemporaryFolder directory;
  const Mesh tube = scaled(standing_tube(), 1e-3);
  for (const auto& file : tube_in_every_format()) {
    SCOPED_TRACE(file.name);
    ImportOptions options;
    if (file.stated_unit == 0) options.metres_per_unit = 1e-3;
    const ImportedPart part = import_part(directory.write(file.name, file.bytes), options);
    EXPECT_EQ(part.unit_from_file, file.stated_unit > 0);
    EXPECT_DOUBLE_EQ(part.metres_per_unit, file.stated_unit > 0 ? file.stated_unit : 1e-3);
    EXPECT_FALSE(part.curved);
    EXPECT_EQ(part.parts.size(), 1U);
    EXPECT_EQ(part.mesh.triangles.size(), tube.triangles.size());
    EXPECT_NEAR(part.mesh.volume(), tube.volume(), 2e-6 * tube.volume());
    EXPECT_LT((part.mesh.bounding_box().lower - tube.bounding_box().lower).norm(), 1e-8);
    EXPECT_LT((part.mesh.bounding_box().upper - tube.bounding_box().upper).norm(), 1e-8);
    EXPECT_TRUE(check_mesh(part.mesh).usable());
  }
}

TEST(CadFormats, AUnitThatContradictsTheFileIsRefused) {
  const TemporaryFolder directory;
  for (const auto& file : tube_in_every_format()) {
    if (file.stated_unit == 0) continue;
    SCOPED_TRACE(file.name);
    ImportOptions options;
    options.metres_per_unit = 1e-6;
    const auto path = directory.write(file.name, file.bytes);
    try {
      import_part(path, options);
      ADD_FAILURE() << "accepted";
    } catch (const MeshError& error) {
      EXPECT_NE(std::string(error.what()).find("states its unit, "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("but um is given"), std::string::npos) << error.what();
    }
  }
}

TEST(CadFormats, AUnitThatNobodyStatesIsAskedFor) {
  const TemporaryFolder directory;
  const auto file = directory.write("tube.off", sample::off(standing_tube()));
  EXPECT_THROW(import_part(file, {}), MeshError);
}

TEST(CadFormats, PartsArePickedByName) {
  const TemporaryFolder directory;
  const std::vector<sample::NamedMesh> parts = {{"die", sample::box({0, 0, 0}, {10, 10, 10})},
                                                {"punch", sample::box({20, 0, 0}, {23, 4, 5})}};
  for (const auto& [name, bytes] : {std::pair{"two.3mf", sample::three_mf(parts, "millimeter")},
                                    {"two.obj", sample::obj_of_parts(parts)},
                                    {"two.stl", sample::stl_of_parts(parts)}}) {
    SCOPED_TRACE(name);
    const auto file = directory.write(name, bytes);
    ImportOptions options;
    options.metres_per_unit = 1e-3;
    EXPECT_NEAR(import_part(file, options).mesh.volume(), 1060e-9, 1e-14);
    options.part = "punch";
    const ImportedPart punch = import_part(file, options);
    EXPECT_EQ(punch.parts, (std::vector<std::string>{"die", "punch"}));
    EXPECT_NEAR(punch.mesh.volume(), 60e-9, 1e-15);
    options.part = "punsh";
    try {
      import_part(file, options);
      ADD_FAILURE() << "accepted";
    } catch (const UnknownPart& error) {
      EXPECT_EQ(error.known, punch.parts);
      EXPECT_NE(std::string(error.what()).find("has no part \"punsh\": it contains \"die\", \"punch\""),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(CadFormats, SupportsForPrintingAreNoPartOfATool) {
  const TemporaryFolder directory;
  const std::vector<sample::NamedMesh> parts = {{"die", sample::box({0, 0, 0}, {10, 10, 10})},
                                                {"prop", sample::box({20, 0, 0}, {23, 4, 5})}};
  for (const std::string type : {"support", "solidsupport"}) {
    const auto file = directory.write("die.3mf", sample::three_mf(parts, "millimeter", type));
    const ImportedPart part = import_part(file, {});
    EXPECT_NEAR(part.mesh.volume(), 1e-6, 1e-14) << type;
    EXPECT_EQ(part.parts, std::vector<std::string>{"die"});
    EXPECT_EQ(part.remarks, std::vector<std::string>{"supports for printing ignored: 1"});
  }
}

TEST(CadFormats, PartsOfOneNameHaveToBeToldApart) {
  const TemporaryFolder directory;
  const std::vector<sample::NamedMesh> parts = {{"pin", sample::box({0, 0, 0}, {1, 1, 1})},
                                                {"pin", sample::box({20, 0, 0}, {22, 1, 1})},
                                                {"cup 12 high", sample::box({0, 5, 0}, {3, 6, 1})}};
  const auto file = directory.write("pins.3mf", sample::three_mf(parts, "millimeter"));
  ImportOptions options;
  options.part = "pin";
  try {
    import_part(file, options);
    ADD_FAILURE() << "accepted";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("part \"pin\" occurs more than once: \"pin (1)\" around (0.50, 0.50, 0.50) mm, "
                        "\"pin (2)\" around (21.00, 0.50, 0.50) mm"),
              std::string::npos)
        << error.what();
  }
  options.part = "pin (1)";
  EXPECT_NEAR(import_part(file, options).mesh.volume(), 1e-9, 1e-16);
  options.part = "cup";  // the only name that begins so
  EXPECT_NEAR(import_part(file, options).mesh.volume(), 3e-9, 1e-16);
}

TEST(CadFormats, NoFileOutsideTheFolderIsRead) {
  const TemporaryFolder directory;
  const std::string good = sample::gltf(sample::box({0, 0, 0}, {1, 1, 1}), "box");
  const std::size_t begin = good.find("data:"), end = good.find('"', begin);
  std::filesystem::create_symlink("/etc/passwd", directory.path() / "link.bin");
  for (const std::string name : {"../../../../../etc/passwd", "/etc/passwd", "%2e%2e/%2e%2e/etc/passwd",
                                 "link.bin", "http://example.org/a.bin", "none.bin"}) {
    SCOPED_TRACE(name);
    std::string text = good;
    text.replace(begin, end - begin, name);
    try {
      import_part(directory.write("box.gltf", text), {});
      ADD_FAILURE() << "accepted";
    } catch (const MeshError& error) {
      EXPECT_NE(std::string(error.what()).find("it refers to '" + name + "', which "), std::string::npos)
          << error.what();
    }
  }
}

TEST(CadFormats, PartsOfOneNameAreTold) {
  const TemporaryFolder directory;
  const std::vector<sample::NamedMesh> parts = {{"pin", sample::box({0, 0, 0}, {1, 1, 1})},
                                                {"pin", sample::box({20, 0, 0}, {22, 1, 1})}};
  const auto file = directory.write("pins.3mf", sample::three_mf(parts, "millimeter"));
  ImportOptions options;
  options.part = "pin (2)";
  EXPECT_NEAR(import_part(file, options).mesh.volume(), 2e-9, 1e-16);
}

}  // namespace
}  // namespace diefill::geometry
