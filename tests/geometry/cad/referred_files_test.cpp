// Files that a CAD file refers to.
#include "geometry/cad/referred_files.h"

#include <gtest/gtest.h>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

using support::TemporaryFolder;
using Paths = std::vector<std::filesystem::path>;

TEST(ReferredFiles, OfGltfAreBuffersAndImagesInItsFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  for (const char* name : {"a.bin", "sub/b c.bin", "skin.png"}) folder.write(name, "bytes");
  const std::string document = R"({"buffers": [{"uri": "a.bin"}, {"uri": "sub/b%20c.bin"}, {"uri": "./a.bin"},
    {"uri": "data:application/octet-stream;base64,AAAA"}, {"uri": "missing.bin"}, {"uri": "../up.bin"},
    {"uri": "/etc/passwd"}, {"uri": "sub"}, {"uri": 3}, {"byteLength": 4}, 5], "images": [{"uri": "skin.png"}]})";
  const auto gltf = folder.write("part.GLTF", document);
  EXPECT_EQ(referred_files(gltf), (Paths{"a.bin", "sub/b c.bin", "skin.png"}));
  const auto size = static_cast<char>(document.size() % 256), more = static_cast<char>(document.size() / 256);
  const std::string head =
      std::string("glTF\x02\0\0\0\0\0\0\0", 12) + size + more + std::string("\0\0JSON", 6);
  EXPECT_EQ(referred_files(folder.write("part.glb", head + document)), referred_files(gltf));
  for (const std::string broken : {"", "{", "[]", "{\"buffers\": 3}", "glTF"})
    EXPECT_TRUE(referred_files(folder.write("broken.gltf", broken + " ")).empty()) << broken;
}

TEST(ReferredFiles, OfObjAreMaterials) {
  const TemporaryFolder folder;
  for (const char* name : {"red.mtl", "blue.mtl", "old paint.mtl"}) folder.write(name, "newmtl x");
  const auto obj = folder.write(
      "part.obj", "# mtllib no.mtl\nmtllib red.mtl blue.mtl\nmtllib old paint.mtl \r\nv 0 0 0\n");
  EXPECT_EQ(referred_files(obj), (Paths{"red.mtl", "blue.mtl", "old paint.mtl"}));
  EXPECT_TRUE(referred_files(folder.write("part.stl", "mtllib red.mtl\n")).empty());
}

TEST(ReferredFiles, CountInTheHash) {
  const TemporaryFolder folder;
  folder.write("a.bin", "bytes");
  const auto gltf = folder.write("part.gltf", R"({"buffers": [{"uri": "a.bin"}]})");
  const std::string before = file_hash(gltf);
  EXPECT_EQ(file_hash(gltf), before);
  folder.write("a.bin", "Bytes");
  EXPECT_NE(file_hash(gltf), before);
}

}  // namespace
}  // namespace diefill::geometry
