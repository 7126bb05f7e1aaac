// Importing CAD files: every format gives the same solid, and every kind of broken file one clear line.
#include "geometry/cad/mesh_import.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <regex>

#include "geometry/cad/cad_child.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

using support::TemporaryFolder;

std::string import_error(const std::filesystem::path& file) {
  try {
    import_mesh(file, 1e-3);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

void expect_error(const std::filesystem::path& file, const std::string& words) {
  const std::string message = import_error(file);
  EXPECT_NE(message.find(words), std::string::npos) << "message was: " << message;
  EXPECT_NE(message.find(file.filename().string()), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(MeshImport, EveryFormatGivesTheSameTube) {
  const Mesh tube = sample::tube(8, 12, 10, 90);
  const TemporaryFolder directory;
  for (const auto& [name, bytes] : {std::pair("text.stl", sample::ascii_stl(tube)),
                                    {"binary.STL", sample::binary_stl(tube)},
                                    {"tube.obj", sample::obj(tube)},
                                    {"tube.ply", sample::ply(tube)}}) {
    const Mesh read = import_mesh(directory.write(name, bytes), 1e-3);
    EXPECT_EQ(read.vertices.size(), tube.vertices.size()) << name;
    EXPECT_EQ(read.triangles.size(), tube.triangles.size()) << name;
    EXPECT_NEAR(read.volume(), tube.volume() * 1e-9, 1e-6 * tube.volume() * 1e-9) << name;
    EXPECT_NEAR((read.bounding_box().upper - 1e-3 * tube.bounding_box().upper).norm(), 0, 2e-9) << name;
  }
}

TEST(MeshImport, TellsThatTheReaderRefusedAFile) {
  const TemporaryFolder directory;
  const auto file =
      directory.write("a.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  try {
    import_mesh(file, 1e-3);
    FAIL() << "it has no shapes";
  } catch (const UnreadableFile& error) {
    EXPECT_EQ(error.failure, ChildFailure::kRefused);
  }
}

TEST(MeshImport, JoinsCornersThatDifferByRoundingOnly) {
  Mesh soup;
  const Mesh box = sample::box({0, 0, 0}, {100, 50, 20});
  for (const Eigen::Vector3i& t : box.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int k = 0; k < 3; ++k)
      soup.vertices.push_back(box.vertices[static_cast<std::size_t>(t[k])] * (1 + 2e-8 * (first % 4)));
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  const TemporaryFolder directory;
  EXPECT_EQ(import_mesh(directory.write("box.stl", sample::ascii_stl(soup)), 1e-3).vertices.size(), 8U);
}

TEST(MeshImport, ReadsSeveralSolidsOfOneFile) {
  const TemporaryFolder directory;
  const std::string text = sample::ascii_stl(sample::box({0, 0, 0}, {1, 1, 1})) +
                           sample::ascii_stl(sample::box({5, 0, 0}, {6, 1, 2}));
  const Mesh mesh = import_mesh(directory.write("two.stl", text), 1);
  EXPECT_EQ(mesh.triangles.size(), 24U);
  EXPECT_NEAR(mesh.volume(), 3, 1e-6);
}

TEST(MeshImport, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder directory;
  const std::string box = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  const std::string text = sample::ascii_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  expect_error(directory.path() / "missing.stl", "does not exist");
  expect_error(directory.path(), "is a directory");
  expect_error(directory.write("empty.stl", ""), "is empty");
  expect_error(directory.write("part.sldprt", "anything"), "unsupported format 'sldprt'");
  expect_error(directory.write("noextension", box), "unsupported format ''");
  expect_error(directory.write("short.stl", box.substr(0, box.size() - 7)),
               "declares 12 triangles (684 bytes)");
  expect_error(directory.write("header.stl", box.substr(0, 40) + std::string("\0", 1)), "truncated");
  expect_error(directory.write("cut_text.stl", text.substr(0, text.size() / 2)), "endsolid");
  expect_error(directory.write("none.stl", box.substr(0, 80) + std::string(4, '\0')), "none.stl");
  expect_error(directory.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "points.obj");
  expect_error(directory.write("nonsense.ply", "this is no ply file"), "cannot be read as ply");
  expect_error(directory.write("nonsense.3mf", "this is no archive"), "cannot be read as 3mf");
  expect_error(directory.write("nonsense.obj", std::string("f 1 2 3\n")), "nonsense.obj");
}

TEST(MeshImport, A3mfFileOfAnUnknownUnitIsRefused) {
  const TemporaryFolder directory;
  const std::vector<sample::NamedMesh> parts = {{"box", sample::box({0, 0, 0}, {1, 1, 1})}};
  for (const char* unit : {"parsec", "Inch", "inches"})
    expect_error(directory.write("a.3mf", sample::three_mf(parts, unit)),
                 "its unit is unknown, allowed: micron, millimeter, centimeter, inch, foot, meter");
  ImportOptions options;
  const auto file = directory.write("b.3mf", sample::three_mf(parts, "centimeter"));
  EXPECT_DOUBLE_EQ(import_part(file, options).metres_per_unit, 1e-2);
}

TEST(MeshImport, ReadsNumbersOfFortranAndRemarks) {
  const TemporaryFolder directory;
  const Mesh box = sample::box({0, 0, 0}, {10, 20, 40});
  const std::string obj = std::regex_replace(sample::obj(box), std::regex("\\b([124])0\\b"), "$1.0D+01");
  const std::string off = std::regex_replace(sample::off(box), std::regex("\\b([124])0\\b"), "$1.0d+1");
  const std::string ply = std::regex_replace(sample::ply(box), std::regex("ply\n"), "ply\ncomment of ours\n");
  for (const auto& [name, bytes] : {std::pair("box.obj", obj), {"box.off", off}, {"box.ply", ply}}) {
    SCOPED_TRACE(name);
    EXPECT_NEAR(import_mesh(directory.write(name, bytes), 1e-3).volume(), 8e-6, 1e-12);
  }
}

TEST(MeshImport, ReadsCommentsAfterTheNumbersOfObj) {
  const TemporaryFolder directory;
  const std::string obj = std::regex_replace(sample::obj(sample::box({0, 0, 0}, {10, 20, 40})),
                                             std::regex("\n"), " # 7 of these\n");
  EXPECT_NEAR(import_mesh(directory.write("box.obj", obj), 1e-3).volume(), 8e-6, 1e-12);
}

TEST(MeshImport, TakesRegularFilesAlone) {
  const TemporaryFolder directory;
  const auto pipe = directory.path() / "pipe.stl", device = directory.path() / "zero.stl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", device);
  expect_error(pipe, "is a pipe: give a regular file");
  expect_error(device, "is a device: give a regular file");
  const auto large = directory.write("large.stl", "solid");
  std::filesystem::resize_file(large, std::uintmax_t{3} << 30);
  expect_error(large, "has 3072 MiB, allowed: up to 1024 MiB");
  expect_error(directory.write("wide.stl", "\xff\xfes\0o\0"), "UTF-16");
}

TEST(MeshImport, SaysThatDigitsAreLostFarFromTheOrigin) {
  const TemporaryFolder directory;
  const auto file = [&](const std::string& name, double x) {
    return directory.write(name, sample::binary_stl(sample::box({x, 0, 0}, {x + 80, 20, 20})));
  };
  expect_error(file("georeferenced.stl", 7.5e6), "distorts its shape");
  ImportOptions options;
  options.metres_per_unit = 1e-3;
  EXPECT_EQ(import_part(file("machine.stl", 9000), options).remarks.size(), 1U);
  EXPECT_TRUE(import_part(file("near.stl", 100), options).remarks.empty());
}

TEST(MeshImport, RefusesCoordinatesThatAreNotFinite) {
  const TemporaryFolder directory;
  Mesh mesh = sample::box({0, 0, 0}, {1, 1, 1});
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  expect_error(directory.write("nan.stl", sample::binary_stl(mesh)), "finite");
  mesh.vertices[3].y() = std::numeric_limits<double>::infinity();
  expect_error(directory.write("inf.stl", sample::binary_stl(mesh)), "finite");
}

TEST(MeshImport, RefusesAUnitThatIsNotPositive) {
  const TemporaryFolder directory;
  const auto file = directory.write("box.stl", sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1})));
  EXPECT_THROW(import_mesh(file, 0), MeshError);
  EXPECT_THROW(import_mesh(file, -1), MeshError);
}

TEST(MeshImport, HashNamesTheBytes) {
  const TemporaryFolder directory;
  // Published test vectors of FNV-1a, 64 bit.
  EXPECT_EQ(file_hash(directory.write("a", "a")), "af63dc4c8601ec8c");
  EXPECT_EQ(file_hash(directory.write("foobar", "foobar")), "85944171f73967e8");
  EXPECT_THROW(file_hash(directory.path() / "missing"), MeshError);
}

}  // namespace
}  // namespace diefill::geometry
