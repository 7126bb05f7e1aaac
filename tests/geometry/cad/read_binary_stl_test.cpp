// Binary STL read without a library gives what assimp gives.
#include "geometry/cad/read_binary_stl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/cad/cad_readers.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

/// The bytes of the corner `corner` of triangle `triangle`.
float* corner_in(std::string& bytes, std::size_t triangle, std::size_t corner) {
  return reinterpret_cast<float*>(bytes.data() + 84 + 50 * triangle + 12 + 12 * corner);
}

TEST(BinaryStl, IsReadAsAssimpReadsIt) {
  const support::TemporaryFolder directory;
  std::string bytes = sample::binary_stl(sample::tube(0.008, 0.012, 0.01, 37));
  float minus_zero = -0.0F;
  std::memcpy(corner_in(bytes, 3, 0), &minus_zero, sizeof minus_zero);
  ASSERT_TRUE(is_binary_stl(bytes));
  const auto file = directory.write("tube.stl", bytes);
  const CadParts own = read_binary_stl(bytes), other = read_cad_parts(file, *cad_format(file), 1e-6);
  ASSERT_EQ(own.parts.size(), 1U);
  ASSERT_EQ(other.parts.size(), 1U);
  EXPECT_EQ(own.parts[0].name, other.parts[0].name);
  EXPECT_EQ(own.metres_per_unit, other.metres_per_unit);
  EXPECT_EQ(own.parts[0].mesh.triangles, other.parts[0].mesh.triangles);
  const auto &vertices = own.parts[0].mesh.vertices, &expected = other.parts[0].mesh.vertices;
  ASSERT_EQ(vertices.size(), expected.size());
  EXPECT_EQ(std::memcmp(vertices.data(), expected.data(), vertices.size() * sizeof vertices[0]), 0);
}

TEST(BinaryStl, IsNoneWhereTheLengthSaysOtherwise) {
  const std::string bytes = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_FALSE(is_binary_stl(bytes.substr(0, bytes.size() - 1)));
  EXPECT_FALSE(is_binary_stl(bytes.substr(0, 84)));
  EXPECT_FALSE(is_binary_stl(std::string(84, '\0')));
  EXPECT_FALSE(is_binary_stl(bytes.substr(0, 10)));
  EXPECT_FALSE(is_binary_stl(""));
  EXPECT_FALSE(is_binary_stl(sample::ascii_stl(sample::box({0, 0, 0}, {1, 1, 1}))));
}

TEST(BinaryStl, RemarksOnBytesLeftOver) {
  const std::string bytes = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  ASSERT_TRUE(is_binary_stl(bytes + "x"));
  const CadParts contents = read_binary_stl(bytes + "xyz");
  EXPECT_EQ(contents.parts[0].mesh.triangles.size(), 12U);
  EXPECT_EQ(contents.remarks, std::vector<std::string>{"3 bytes after the last triangle ignored"});
  EXPECT_TRUE(read_binary_stl(bytes).remarks.empty());
}

TEST(BinaryStl, SaysThatTheNumberInItsHeaderMayBeTooSmall) {
  std::string bytes = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  bytes[80] = 8;
  const CadParts contents = read_binary_stl(bytes);
  EXPECT_EQ(contents.parts[0].mesh.triangles.size(), 8U);
  EXPECT_EQ(
      contents.remarks,
      std::vector<std::string>{"200 bytes after the last triangle ignored: as many as 4 triangles have, so "
                               "the number in its header may be too small"});
}

TEST(BinaryStl, OfSeveralFilesOneBehindAnotherHasAPartEach) {
  const CadParts contents = read_binary_stl(sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1})) +
                                            sample::binary_stl(sample::box({0, 0, 0}, {2, 1, 1})));
  ASSERT_EQ(contents.parts.size(), 2U);
  EXPECT_EQ(contents.parts[1].name, "part 2");
  EXPECT_NEAR(contents.parts[1].mesh.volume(), 2, 1e-6);
}

TEST(BinaryStl, WhoseNumberOfTrianglesWasNeverFilledInIsAsLongAsItIs) {
  std::string bytes = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  for (const std::uint32_t count : {0U, ~0U}) {
    std::memcpy(bytes.data() + 80, &count, sizeof count);
    ASSERT_TRUE(is_binary_stl(bytes));
    EXPECT_EQ(read_binary_stl(bytes).parts[0].mesh.triangles.size(), 12U);
  }
}

TEST(BinaryStl, KeepsCornersThatAreNoNumbersForWhoeverLooksAtThem) {
  std::string bytes = sample::binary_stl(sample::box({0, 0, 0}, {1, 1, 1}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(corner_in(bytes, 5, 1), &nan, sizeof nan);
  const CadParts contents = read_binary_stl(bytes);
  EXPECT_EQ(contents.parts[0].mesh.vertices.size(), 9U);
  EXPECT_EQ(contents.parts[0].mesh.triangles.size(), 12U);
}

TEST(BinaryStl, OfNothingButNumbersThatAreNoneHasOneCorner) {
  const std::uint32_t count = 1000;
  std::string bytes = std::string(84, ' ') + std::string(std::size_t{50} * count, '\xff');
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  ASSERT_TRUE(is_binary_stl(bytes));
  EXPECT_EQ(read_binary_stl(bytes).parts[0].mesh.vertices.size(), 1U);
}

}  // namespace
}  // namespace diefill::geometry
