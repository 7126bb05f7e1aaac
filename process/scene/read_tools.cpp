#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <numbers>
#include <system_error>

#include "process/scene/plausibility.h"
#include "process/scene/sections.h"
#include "process/scene/wall_rules.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kPosition = {Dimension::length, "34 mm", "-10 m", "10 m"};
constexpr QuantityRule kAngle = {Dimension::angle, "90 deg", "-360 deg", "360 deg"};

const Choices<ToolRole>& roles() {
  static const Choices<ToolRole> choices = {{"die", ToolRole::die},
                                            {"core", ToolRole::core},
                                            {"punch", ToolRole::punch},
                                            {"shoe", ToolRole::shoe},
                                            {"plate", ToolRole::plate}};
  return choices;
}

const Choices<double>& length_units() {
  static const Choices<double> choices = {
      {"mm", 1e-3}, {"um", 1e-6}, {"cm", 1e-2}, {"m", 1}, {"inch", 0.0254}};
  return choices;
}

/// Formats of curved faces; only triangles can be covered with wall spheres.
bool has_curved_faces(const std::filesystem::path& file) {
  static const std::vector<std::string> endings = {".step",   ".stp", ".iges", ".igs",    ".x_t",
                                                   ".sldprt", ".ipt", ".prt",  ".catpart"};
  std::string ending = file.extension().string();
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::filesystem::path read_file(TableReader& table) {
  const std::filesystem::path given = table.required_text("file", "die.stl");
  if (given.empty()) table.reject("file", "the name of a CAD file is needed, such as \"die.stl\"");
  const std::filesystem::path file = given.is_absolute() ? given : table.file().parent_path() / given;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    table.reject("file", "there is no file " +
                             std::filesystem::absolute(file, error).lexically_normal().string() +
                             "; give the path from the folder of the scene file");
  }
  if (std::filesystem::is_directory(status))
    table.reject("file", "this is a folder; name a CAD file in it, such as \"die.stl\"");
  if (has_curved_faces(file)) {
    table.reject("file",
                 "a triangle mesh is needed (STL, OBJ, PLY); export the part as STL from the CAD program");
  }
  return file;
}

double read_length_unit(TableReader& table) {
  if (!table.has("length_unit")) {
    table.require("length_unit",
                  "\"mm\", because CAD files of triangles do not say what unit their coordinates are in");
  }
  return table.required_choice("length_unit", length_units());
}

Eigen::Matrix3d read_rotation(TableReader& tool) {
  auto table = tool.table("rotation");
  if (!table) return Eigen::Matrix3d::Identity();
  table->require("axis", "\"z\"");
  const Eigen::Vector3d axis = *table->direction("axis");
  const double angle = table->required_quantity("angle", kAngle);
  table->finish();
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

ToolSpec read_tool(TableReader& table, const WallSpec& walls, const PowderSpec& powder) {
  ToolSpec tool;
  tool.line = table.line();
  tool.name = table.required_name("name", "die");
  tool.role = table.required_choice("role", roles());
  tool.file = read_file(table);
  tool.metres_per_unit = read_length_unit(table);
  tool.rotation = read_rotation(table);
  tool.position = table.point("position", kPosition).value_or(Eigen::Vector3d::Zero());
  tool.sphere_radius = table.quantity("sphere_radius", kWallSphereRadius);
  tool.spacing = table.number("spacing", kWallSpacing);
  table.finish();
  check_wall_is_tight(table, tool.sphere_radius.value_or(walls.sphere_radius),
                      tool.spacing.value_or(walls.spacing), powder);
  return tool;
}

}  // namespace

std::vector<ToolSpec> read_tools(TableReader& document, const WallSpec& walls, const PowderSpec& powder) {
  std::vector<ToolSpec> tools;
  document.require(
      "tool",
      "a [[tool]] table with name, role, file and length_unit: without a tool there is nothing to fill");
  for (TableReader& table : document.tables("tool")) {
    ToolSpec tool = read_tool(table, walls, powder);
    const auto same = [&tool](const ToolSpec& other) { return other.name == tool.name; };
    const auto earlier = std::find_if(tools.begin(), tools.end(), same);
    if (earlier != tools.end()) {
      table.reject("name", "the tool on line " + std::to_string(earlier->line) +
                               " has that name already; give each tool its own");
    }
    tools.push_back(std::move(tool));
  }
  if (tools.empty()) document.reject("tool", "at least one [[tool]] table is needed");
  return tools;
}

std::string in_words(ToolRole role) {
  for (const auto& [word, value] : roles()) {
    if (value == role) return word;
  }
  throw std::logic_error("a tool role without a word");
}

}  // namespace diefill::process
