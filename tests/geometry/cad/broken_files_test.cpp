// Broken CAD files, one named defect each: every one gives its own clear finding, and none a crash.
#include "tests/geometry/broken_files.h"

#include <gtest/gtest.h>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_repair.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {

namespace sample {

std::ostream& operator<<(std::ostream& stream, const BrokenFile& broken) {
  return stream << broken.defect;
}

}  // namespace sample

namespace {

class BrokenFiles : public testing::TestWithParam<sample::BrokenFile> {};

std::string everything_said(const std::filesystem::path& file, RepairedMesh& repaired) {
  ImportOptions options;
  if (file.extension() == ".stl" || file.extension() == ".obj" || file.extension() == ".ply" ||
      file.extension() == ".off")
    options.metres_per_unit = 1e-3;
  try {
    const Mesh mesh = import_part(file, options).mesh;
    const MeshFindings found = check_mesh(mesh);
    repaired = repair_mesh(mesh, found, {});
    std::string words;
    for (const auto& line : found.description()) words += line + "; ";
    return words;
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos) << error.what();
    return error.what();
  }
}

TEST_P(BrokenFiles, GiveTheirOwnFinding) {
  const support::TemporaryFolder directory;
  const sample::BrokenFile& broken = GetParam();
  RepairedMesh repaired;
  const std::string said = everything_said(directory.write(broken.file, broken.bytes), repaired);
  EXPECT_NE(said.find(broken.words), std::string::npos) << "said: " << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  const std::string repairs = testing::PrintToString(repaired.repairs);
  if (broken.repair.empty()) {
    EXPECT_TRUE(repaired.repairs.empty()) << repairs;
  } else {
    EXPECT_NE(repairs.find(broken.repair), std::string::npos) << repairs;
    EXPECT_TRUE(repaired.findings.usable()) << testing::PrintToString(repaired.findings.description());
  }
}

std::string name_of(const testing::TestParamInfo<sample::BrokenFile>& instance) {
  return instance.param.defect;
}

INSTANTIATE_TEST_SUITE_P(Bytes, BrokenFiles, testing::ValuesIn(sample::broken_bytes()), name_of);
INSTANTIATE_TEST_SUITE_P(Meshes, BrokenFiles, testing::ValuesIn(sample::broken_meshes()), name_of);

TEST(BrokenFilesList, AreThirtyAtLeast) {
  EXPECT_GE(sample::broken_bytes().size() + sample::broken_meshes().size(), 30U);
}

}  // namespace
}  // namespace diefill::geometry
