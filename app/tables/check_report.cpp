#include "app/tables/check_report.h"

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "process/estimate/statements/wording.h"

namespace diefill::app {

namespace {

using Json = nlohmann::ordered_json;

Json point(const Eigen::Vector3d& p) {
  return Json::array({p[0], p[1], p[2]});
}

Json findings_as_json(const geometry::MeshFindings& findings) {
  return {{"usable", findings.usable()},
          {"triangles", findings.triangles},
          {"shells", findings.shells},
          {"volume_m3", findings.volume},
          {"open_edges", findings.open_edges},
          {"non_manifold_edges", findings.non_manifold_edges},
          {"badly_oriented_edges", findings.badly_oriented_edges},
          {"inward_shells", findings.inward_shells},
          {"self_intersections", findings.self_intersections},
          {"degenerate_triangles", findings.degenerate_triangles},
          {"duplicate_triangles", findings.duplicate_triangles},
          {"text", findings.description()}};
}

Json symmetry_as_json(const geometry::Symmetry& symmetry) {
  Json json = {{"centre_m", point(symmetry.centre)},
               {"planes", Json::array()},
               {"axes", Json::array()},
               {"text", symmetry.description()}};
  for (const auto& normal : symmetry.planes) json["planes"].push_back(point(normal));
  for (const auto& axis : symmetry.axes)
    json["axes"].push_back({{"direction", point(axis.direction)}, {"order", axis.order}});
  return json;
}

Json tool_as_json(const process::Tool& tool) {
  const geometry::Box box = tool.mesh.bounding_box();
  Json json = {{"name", tool.spec.name},
               {"role", process::description(tool.spec.role)},
               {"file", tool.spec.file.string()},
               {"parts_in_file", tool.file_parts},
               {"metres_per_unit", tool.metres_per_unit},
               {"unit_from_file", tool.unit_from_file},
               {"lower_corner_m", point(box.lower)},
               {"upper_corner_m", point(box.upper)},
               {"found", findings_as_json(tool.found)},
               {"file_remarks", tool.file_remarks},
               {"repairs", tool.repairs},
               {"not_repaired", tool.not_repaired},
               {"mesh", findings_as_json(tool.findings)}};
  if (tool.chord_tolerance) json["chord_tolerance_m"] = *tool.chord_tolerance;
  if (tool.wall_mesh) json["wall_triangles"] = tool.wall_mesh->triangles.size();
  const auto& spheres = tool.spheres;
  if (!spheres.centres.empty())
    json["wall_spheres"] = {{"count", spheres.centres.size()},
                            {"radius_m", spheres.radius},
                            {"mean_deviation_m", spheres.mean_deviation},
                            {"largest_deviation_m", spheres.largest_deviation},
                            {"largest_gap_m", spheres.largest_gap}};
  return json;
}

Json pair_as_json(const process::PairDiagnosis& pair) {
  Json json = {{"tools", {pair.one, pair.other}},
               {"overlap_m", pair.overlap},
               {"powder_enters", pair.powder_enters},
               {"real_powder_enters", pair.real_powder_enters},
               {"text", pair.description}};
  if (pair.gap.found)
    json["gap"] = {{"narrowest_m", pair.gap.narrowest},
                   {"widest_m", pair.gap.widest},
                   {"widest_place_m", point(pair.gap.widest_place)}};
  return json;
}

/// Marks of one mesh as its file has it, a finding for each kind.
void add_mesh_marks(const process::Tool& tool, std::vector<render::FindingMark>& findings) {
  std::map<std::string, std::vector<Eigen::Vector3d>> places;
  std::vector<std::string> kinds;
  for (const auto& mark : tool.found.marks) {
    if (places.find(mark.kind) == places.end()) kinds.push_back(mark.kind);
    places[mark.kind].push_back(mark.place);
  }
  const auto words = tool.found.description();
  for (std::size_t k = 0; k < kinds.size() && k < words.size(); ++k) {
    const bool harmless = tool.findings.usable() || kinds[k] == "without area" || kinds[k] == "twice";
    findings.push_back({harmless ? render::MarkKind::kCare : render::MarkKind::kFault,
                        tool.spec.name + ": " + words[k], places.at(kinds[k])});
  }
}

void print_cavity(const std::string& name, const geometry::Cavity& cavity, double fill_plane) {
  const Eigen::Vector3d place = 1e3 * cavity.narrowest_place;
  std::printf(
      "%s: volume %.4g cm3, depth %.2f mm below z = %.2f mm, narrowest width %.3f mm near (%.2f, %.2f, "
      "%.2f) mm",
      name.c_str(), 1e6 * cavity.volume, 1e3 * cavity.box.size()[2], 1e3 * fill_plane,
      1e3 * cavity.narrowest_width, place[0], place[1], place[2]);
  if (cavity.is_ring)
    std::printf(", ring of %.2f to %.2f mm diameter", 2e3 * cavity.inner_radius, 2e3 * cavity.outer_radius);
  std::printf("\n");
}

/// "cavity 2 at x = 12.5 mm, y = 0 mm", as estimates and figures number them.
std::string numbered(std::size_t number, const geometry::Cavity& cavity) {
  return "cavity " + std::to_string(number) + process::estimate::place_text(cavity.axis_origin.head<2>());
}

Json cavity_as_json(const geometry::Cavity& cavity) {
  return {{"volume_m3", cavity.volume},
          {"depth_m", cavity.box.size()[2]},
          {"narrowest_width_m", cavity.narrowest_width},
          {"narrowest_place_m", point(cavity.narrowest_place)},
          {"is_ring", cavity.is_ring}};
}

render::FindingMark width_mark(const geometry::Cavity& cavity) {
  char text[80];
  std::snprintf(text, sizeof text, "narrowest width of the cavity, %.3f mm", 1e3 * cavity.narrowest_width);
  return {render::MarkKind::kFact, text, {cavity.narrowest_place}};
}

}  // namespace

void print_tool(const process::Tool& tool, const geometry::Symmetry* symmetry) {
  const geometry::Box box = tool.mesh.bounding_box();
  const Eigen::Vector3d size = 1e3 * box.size();
  const Eigen::Vector3d lower = 1e3 * box.lower;
  const Eigen::Vector3d upper = 1e3 * box.upper;
  std::printf("%s (%s): %zu triangles, %.2f x %.2f x %.2f mm, volume %.4g cm3\n", tool.spec.name.c_str(),
              process::description(tool.spec.role).c_str(), tool.mesh.triangles.size(), size[0], size[1],
              size[2], 1e6 * tool.mesh.volume());
  std::printf("  extent: from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) mm\n", lower[0], lower[1], lower[2],
              upper[0], upper[1], upper[2]);
  if (tool.chord_tolerance)
    std::printf("  curved surfaces triangulated within %.3g mm, file unit %.4g mm\n",
                1e3 * *tool.chord_tolerance, 1e3 * tool.metres_per_unit);
  for (const auto& remark : tool.file_remarks) std::printf("  file: %s\n", remark.c_str());
  if (!tool.repairs.empty())
    for (const auto& finding : tool.found.description()) std::printf("  found: %s\n", finding.c_str());
  for (const auto& repair : tool.repairs) std::printf("  repaired: %s\n", repair.c_str());
  for (const auto& finding : tool.findings.description()) std::printf("  mesh: %s\n", finding.c_str());
  for (const auto& refused : tool.not_repaired) std::printf("  not repaired: %s\n", refused.c_str());
  if (tool.findings.description().empty())
    std::printf("  mesh: closed, oriented, free of self-intersections, %zu shell%s\n", tool.findings.shells,
                tool.findings.shells == 1 ? "" : "s");
  if (symmetry != nullptr) std::printf("  symmetry: %s\n", symmetry->description().c_str());
  if (tool.wall_mesh)
    std::printf("  walls: the mesh itself, %zu triangles\n", tool.wall_mesh->triangles.size());
  const auto& spheres = tool.spheres;
  if (spheres.centres.empty()) return;
  std::printf(
      "  wall spheres: %zu of radius %.4g mm; envelope to CAD surface: mean %.3g mm, largest %.3g mm; "
      "largest gap "
      "%.3g mm\n",
      spheres.centres.size(), 1e3 * spheres.radius, 1e3 * spheres.mean_deviation,
      1e3 * spheres.largest_deviation, 1e3 * spheres.largest_gap);
}

void print_pairs(const process::Diagnosis& diagnosis) {
  for (const auto& pair : diagnosis.pairs)
    std::printf("%s and %s: %s\n", pair.one.c_str(), pair.other.c_str(), pair.description.c_str());
}

void print_cavities(const process::Tooling& tooling) {
  if (!tooling.cavity.found) {
    std::printf("cavity: none below the fill plane, z = %.2f mm\n", 1e3 * tooling.fill_plane);
    return;
  }
  if (tooling.other_cavities.empty()) {
    print_cavity("cavity", tooling.cavity, tooling.fill_plane);
    return;
  }
  print_cavity(numbered(1, tooling.cavity), tooling.cavity, tooling.fill_plane);
  for (std::size_t k = 0; k < tooling.other_cavities.size(); ++k)
    print_cavity(numbered(k + 2, tooling.other_cavities[k]), tooling.other_cavities[k], tooling.fill_plane);
  std::printf("figures and maps refer to the largest of the %zu cavities; report.json lists the others\n",
              tooling.other_cavities.size() + 1);
}

Json tools_as_json(const process::Tooling& tooling, const process::Diagnosis& diagnosis) {
  Json json = {{"tools", Json::array()},
               {"pairs", Json::array()},
               {"fill_plane_m", tooling.fill_plane},
               {"cavity", nullptr}};
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    Json tool = tool_as_json(tooling.tools[k]);
    if (k < diagnosis.symmetry.size()) tool["symmetry"] = symmetry_as_json(diagnosis.symmetry[k]);
    json["tools"].push_back(std::move(tool));
  }
  for (const auto& pair : diagnosis.pairs) json["pairs"].push_back(pair_as_json(pair));
  if (tooling.cavity.found) json["cavity"] = cavity_as_json(tooling.cavity);
  for (const auto& other : tooling.other_cavities) json["smaller_cavities"].push_back(cavity_as_json(other));
  return json;
}

std::vector<render::FindingMark> marks_of(const process::Tooling& tooling,
                                          const process::Diagnosis& diagnosis) {
  std::vector<render::FindingMark> findings;
  for (const auto& tool : tooling.tools) add_mesh_marks(tool, findings);
  for (const auto& pair : diagnosis.pairs) {
    const std::string names = pair.one + " and " + pair.other + ": ";
    if (pair.powder_enters || pair.real_powder_enters)
      findings.push_back({render::MarkKind::kCare, names + pair.description, {pair.gap.widest_place}});
    else if (pair.overlap > 0)
      findings.push_back({render::MarkKind::kFact, names + pair.description, {pair.overlap_place}});
  }
  if (tooling.cavity.found) findings.push_back(width_mark(tooling.cavity));
  for (const auto& other : tooling.other_cavities) findings.push_back(width_mark(other));
  return findings;
}

std::vector<render::MarkedPart> parts_of(const process::Tooling& tooling) {
  std::vector<render::MarkedPart> parts;
  for (const auto& tool : tooling.tools) parts.push_back({tool.mesh.vertices, tool.mesh.triangles});
  return parts;
}

}  // namespace diefill::app
