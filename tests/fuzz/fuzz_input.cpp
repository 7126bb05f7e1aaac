#include "tests/fuzz/fuzz_input.h"

#include <algorithm>

#include "geometry/cad/cad_child.h"
#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_repair.h"
#include "project_paths.h"
#include "tests/geometry/broken_files.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry::fuzz {

namespace {

constexpr std::size_t kMaxToRepair = 20000;  // triangles: beyond it an input only costs time
constexpr std::size_t kLargestSeed = 40000;  // bytes, for the same reason

const std::vector<std::string>& endings() {
  static const std::vector<std::string> all = {"stl", "obj",  "ply", "off",  "3mf", "amf",
                                               "dae", "gltf", "glb", "step", "igs"};
  return all;
}

FuzzInput sample_tool(const std::string& file) {
  const std::filesystem::path path = std::string(DIEFILL_SOURCE_DIR "/sample_tools/").append(file);
  return {path.extension().string().substr(1), support::contents(path)};
}

std::vector<FuzzInput> whole_files() {
  const Mesh tube = sample::tube(8, 12, 10, 12), box = sample::box({0, 0, 0}, {1, 2, 3});
  const std::vector<sample::NamedMesh> parts = {{"die", box}, {"punch", tube}};
  return {{"stl", sample::binary_stl(tube)},    {"stl", sample::stl_of_parts(parts)},
          {"obj", sample::obj_of_parts(parts)}, {"ply", sample::ply(box)},
          {"off", sample::off(tube)},           {"3mf", sample::three_mf(parts, "millimeter")},
          {"amf", sample::amf(box, "inch")},    {"dae", sample::collada(box, 1e-3)},
          {"gltf", sample::gltf(box, "die")},   sample_tool("shoe/shoe.step"),
          sample_tool("shoe/shoe.igs"),         sample_tool("narrow_ring/narrow_ring_d1.88.step")};
}

std::string refusal(ChildFailure failure) {
  switch (failure) {
    case ChildFailure::kCrashed:
      return "refused, importer crashed";
    case ChildFailure::kTooLong:
      return "refused, importer took too long";
    case ChildFailure::kTooMuchMemory:
      return "refused, importer took too much memory";
    case ChildFailure::kNoChild:
      return "refused, no process to read in";
    case ChildFailure::kRefused:
      break;
  }
  return "refused";
}

}  // namespace

std::vector<FuzzInput> seeds() {
  std::vector<FuzzInput> all = whole_files();
  for (const auto& broken : {sample::broken_bytes(), sample::broken_meshes()})
    for (const sample::BrokenFile& file : broken)
      all.push_back({std::filesystem::path(file.file).extension().string().substr(1), file.bytes});
  std::erase_if(all, [](const FuzzInput& input) { return input.bytes.size() > kLargestSeed; });
  return all;
}

std::string packed(const FuzzInput& input) {
  const auto kind = std::find(endings().begin(), endings().end(), input.ending) - endings().begin();
  return static_cast<char>(kind) + input.bytes;
}

FuzzInput unpacked(const std::string& bytes) {
  const auto kind = static_cast<unsigned char>(bytes.at(0));
  return {endings()[kind % endings().size()], bytes.substr(1)};
}

std::string outcome_of(const std::filesystem::path& file) {
  ImportOptions options;
  const std::string ending = file.extension().string();
  if (ending == ".stl" || ending == ".obj" || ending == ".ply" || ending == ".off")
    options.metres_per_unit = 1e-3;
  try {
    const Mesh mesh = import_part(file, options).mesh;
    const MeshFindings findings = check_mesh(mesh);
    if (mesh.triangles.size() > kMaxToRepair) return "read, too large to repair";
    const RepairedMesh repaired = repair_mesh(mesh, findings, {});
    if (findings.usable()) return "read, usable";
    return repaired.findings.usable() ? "read, repaired" : "read, not usable";
  } catch (const UnreadableFile& error) {
    return refusal(error.failure);
  } catch (const MeshError&) {
    return "refused";
  }
}

}  // namespace diefill::geometry::fuzz
