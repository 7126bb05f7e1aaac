// From a tool's CAD file to its mesh in the laboratory.
#include <Eigen/Geometry>
#include <algorithm>
#include <future>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/mesh_repair.h"
#include "process/input/nearest_key.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

namespace {

constexpr double kChordOverRadius = 0.01;   // facets then stay well below what the wall spheres leave open
constexpr double kWrapOverRadius = 2;       // finer features vanish between wall spheres
constexpr std::size_t kListedRefusals = 3;  // a damaged mesh has thousands of holes

double wall_radius(const Scene& scene, const ToolSpec& spec) {
  return spec.sphere_radius.value_or(scene.walls.sphere_radius);
}

geometry::ImportedPart read_file(const Scene& scene, const ToolSpec& spec, double chord_tolerance) {
  geometry::ImportOptions options;
  if (spec.metres_per_unit > 0) options.metres_per_unit = spec.metres_per_unit;
  options.part = spec.part;
  options.chord_tolerance = chord_tolerance;
  try {
    return geometry::import_part(spec.file, options);
  } catch (const geometry::UnknownPart& unknown) {
    const auto nearest = nearest_key(spec.part, unknown.known);
    throw SceneError(tool_text(scene, spec) + ": " + unknown.what() +
                     (nearest ? "; did you mean \"" + *nearest + "\"?" : "; use one of these names"));
  } catch (const geometry::MeshError& error) {
    throw SceneError(tool_text(scene, spec) + ": " + error.what());
  } catch (const geometry::MissingLibrary& missing) {
    throw geometry::MissingLibrary(tool_text(scene, spec) + ": " + missing.what());
  }
}

/// Mirrored first, then turned, then shifted.
geometry::Mesh placed(geometry::Mesh mesh, const ToolSpec& spec) {
  Eigen::Matrix3d turn = spec.rotation;
  if (spec.mirror.norm() > 0) {
    turn *= Eigen::Matrix3d::Identity() - 2 * spec.mirror * spec.mirror.transpose();
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return geometry::transformed(mesh, turn, spec.position);
}

/// Findings of an unusable mesh in one line.
std::string in_one_line(const Tool& tool) {
  std::string text;
  for (const auto& finding : tool.findings.description()) text += (text.empty() ? "" : "; ") + finding;
  const std::size_t listed = std::min(tool.not_repaired.size(), kListedRefusals);
  for (std::size_t k = 0; k < listed; ++k) text += "; not repaired: " + tool.not_repaired[k];
  if (listed < tool.not_repaired.size())
    text += "; and " + std::to_string(tool.not_repaired.size() - listed) + " more that are not repaired";
  for (const auto& remark : tool.file_remarks) text += "; its file: " + remark;
  return text;
}

/// Checks the mesh, repairs it as far as the tool's spec allows, and makes it the tool's.
void examine(geometry::Mesh mesh, double wall_radius, Tool& tool) {
  geometry::ExaminedMesh examined = geometry::examine_mesh(mesh);
  tool.found = examined.findings;
  if (tool.found.usable() && tool.found.duplicate_triangles == 0) {
    tool.findings = tool.found;
    tool.mesh = std::move(mesh);
    tool.keep(std::move(*examined.topology));
    return;
  }
  geometry::RepairOptions options;
  options.level = tool.spec.repair;
  options.wrap_detail = kWrapOverRadius * wall_radius;
  geometry::RepairedMesh repaired = geometry::repair_mesh(mesh, tool.found, options);
  tool.mesh = std::move(repaired.mesh);
  tool.findings = std::move(repaired.findings);
  tool.repairs = std::move(repaired.repairs);
  tool.not_repaired = std::move(repaired.refused);
}

}  // namespace

std::string tool_text(const Scene& scene, const ToolSpec& spec) {
  return scene.file.string() + ":" + std::to_string(spec.line) + ": tool \"" + spec.name + "\"";
}

Tool read_tool(const Scene& scene, const ToolSpec& spec) {
  Tool tool;
  tool.spec = spec;
  const double chord = spec.chord_tolerance.value_or(kChordOverRadius * wall_radius(scene, spec));
  // Beside the reading, which it would take seconds of for large files.
  auto hash = std::async(std::launch::async, geometry::file_hash, spec.file);
  geometry::ImportedPart part = read_file(scene, spec, chord);
  tool.file_parts = part.parts;
  tool.metres_per_unit = part.metres_per_unit;
  tool.unit_from_file = part.unit_from_file;
  if (part.curved) tool.chord_tolerance = chord;
  tool.file_remarks = part.remarks;
  tool.file_hash = hash.get();
  geometry::Mesh mesh = placed(std::move(part.mesh), spec);
  check_size(mesh,
             {wall_radius(scene, spec), spec.sphere_radius ? "its sphere_radius" : "walls.sphere_radius"},
             {part.metres_per_unit, part.unit_from_file}, tool_text(scene, spec));
  examine(std::move(mesh), wall_radius(scene, spec), tool);
  return tool;
}

void refuse_unusable(const Scene& scene, const Tool& tool) {
  if (tool.findings.usable()) return;
  throw SceneError(tool_text(scene, tool.spec) + ": " + tool.spec.file.string() +
                   " does not enclose a solid: " + in_one_line(tool) +
                   "; repair the CAD model and export it again");
}

}  // namespace diefill::process
