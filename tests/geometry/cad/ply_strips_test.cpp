// Triangle strips of PLY files give the same solid as its triangles do.
#include "geometry/cad/ply_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_check.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

/// Of a block with the corners (0 or 1, 0 or 2, 0 or 3), numbered in binary: its sides as one strip of
/// fourteen corners, as two, and as one that is joined by triangles without extent.
const std::vector<std::vector<int>> kStrips = {
    {6, 7, 2, 3, 1, 7, 5, 6, 4, 2, 0, 1, 4, 5},
    {6, 7, 2, 3, 1, 7, 5, 6, -1, 5, 6, 4, 2, 0, 1, 4, 5, -1},
    {6, 7, 2, 3, 1, 7, 5, 6, 6, 5, 5, 6, 4, 2, 0, 1, 4, 5},
};

std::string head(const std::string& format, std::size_t strips, const std::string& types) {
  return "ply\nformat " + format +
         " 1.0\ncomment of a test\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "element tristrips " +
         std::to_string(strips) + "\nproperty list " + types + " vertex_indices\nend_header\n";
}

std::string text_ply(const std::vector<int>& strip) {
  std::ostringstream out;
  out << head("ascii", 1, "int int");
  for (int k = 0; k < 8; ++k)
    out << (k & 1) << ' ' << 2 * ((k >> 1) & 1) << ' ' << 3 * ((k >> 2) & 1) << '\n';
  out << strip.size();
  for (const int corner : strip) out << ' ' << corner;
  out << '\n';
  return out.str();
}

/// The bytes of `value`, the least first, or the other way round.
template <class Value>
std::string bytes_of(Value value, bool is_big_endian) {
  std::string bytes(sizeof value, '\0');
  std::copy_n(reinterpret_cast<const char*>(&value), sizeof value, bytes.begin());
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

template <class Index>
std::string binary_ply(const std::vector<int>& strip, bool big, const std::string& types) {
  std::string bytes = head(big ? "binary_big_endian" : "binary_little_endian", 1, types);
  for (int k = 0; k < 8; ++k)
    for (const int coordinate : {k & 1, 2 * ((k >> 1) & 1), 3 * ((k >> 2) & 1)})
      bytes += bytes_of(static_cast<float>(coordinate), big);
  bytes += bytes_of(static_cast<std::uint8_t>(strip.size()), big);
  for (const int corner : strip) bytes += bytes_of(static_cast<Index>(corner), big);
  return bytes;
}

Mesh read(const std::string& bytes) {
  const support::TemporaryFolder directory;
  return import_mesh(directory.write("strips.ply", bytes), 1e-3);
}

std::string complaint_about(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

void expect_block(const Mesh& mesh) {
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_TRUE(check_mesh(mesh).usable()) << testing::PrintToString(check_mesh(mesh).description());
  EXPECT_NEAR(mesh.volume(), 6e-9, 1e-15);
}

TEST(PlyStrips, OfATextGiveAllTriangles) {
  for (const auto& strip : kStrips) expect_block(read(text_ply(strip)));
}

TEST(PlyStrips, OfABinaryFileGiveAllTriangles) {
  for (const auto& strip : kStrips)
    for (const bool big : {false, true}) {
      expect_block(read(binary_ply<std::int32_t>(strip, big, "uchar int")));
      expect_block(read(binary_ply<std::int16_t>(strip, big, "uchar short")));
      expect_block(read(binary_ply<std::uint32_t>(strip, big, "uchar uint")));
    }
}

TEST(PlyStrips, ThatCannotBeReadAreToldInOneLine) {
  const std::string good = text_ply(kStrips[0]);
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string text = good;
    return text.replace(text.find(old), old.size(), other);
  };
  for (const auto& [bytes, words] :
       {std::pair{with("14 6 7", "14 6 7 7"), "a triangle strip counts 14 corners, but has 15 in its line"},
        {with("14 6 7", "14 6 x"), "a triangle strip has 'x' for the number of a corner"},
        {with("list int int", "list int float"), "its triangle strips are not one list of whole numbers"},
        {with("14 6 7", "14 9 7"), "a corner that does not exist"}}) {
    const std::string said = complaint_about(bytes);
    EXPECT_NE(said.find(words), std::string::npos) << "missing: " << words << "\nin: " << said;
  }
}

TEST(PlyStrips, OtherFilesStayAsTheyAre) {
  const std::string plain = "ply\nformat ascii 1.0\nelement vertex 0\nelement face 0\nend_header\n";
  EXPECT_EQ(with_faces_for_strips(plain), plain);
}

}  // namespace
}  // namespace diefill::geometry
