#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <system_error>

#include "geometry/cad/cad_parts.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"
#include "process/scene/reading/wall_rules.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kPosition = {Dimension::length, "34 mm", "-10 m", "10 m"};
constexpr QuantityRule kChordTolerance = {Dimension::length, "0.002 mm", "1e-5 mm", "1 mm"};
constexpr QuantityRule kUnit = {Dimension::length, "25 um", "0 m", "10 m", true};
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
  static const Choices<double> choices = {{"mm", 1e-3}, {"um", 1e-6},     {"cm", 1e-2},
                                          {"m", 1},     {"inch", 0.0254}, {"in", 0.0254}};
  return choices;
}

const Choices<geometry::RepairLevel>& repair_levels() {
  static const Choices<geometry::RepairLevel> choices = {{"safe", geometry::RepairLevel::kSafe},
                                                         {"off", geometry::RepairLevel::kOff},
                                                         {"wrap", geometry::RepairLevel::kWrap}};
  return choices;
}

std::filesystem::path read_file(TableReader& table) {
  const std::filesystem::path given = table.required_text("file", "die.stl");
  if (given.empty()) table.reject("file", "expected the name of a CAD file, such as \"die.stl\"");
  const std::filesystem::path file = given.is_absolute() ? given : table.file().parent_path() / given;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    table.reject("file",
                 "no such file: " + std::filesystem::absolute(file, error).lexically_normal().string() +
                     "; give the path relative to the scene file");
  }
  if (std::filesystem::is_directory(status))
    table.reject("file", "this is a folder; give a CAD file in it, such as \"die.stl\"");
  if (geometry::cad_format(file) == nullptr)
    table.reject("file", "unsupported file type; export the part as " + geometry::cad_formats_text());
  return file;
}

/// A text that begins as a number does, such as "25 um".
bool is_quantity(const std::string& text) {
  return !text.empty() && std::string("0123456789.+-").find(text.front()) != std::string::npos;
}

/// Where the file states its unit the scene need not, and import_part() sees whether the two agree.
double read_length_unit(TableReader& table, const geometry::CadFormat& format) {
  if (format.states_unit) return table.choice("length_unit", length_units()).value_or(0);
  if (!table.has("length_unit")) {
    table.require("length_unit", "\"mm\", because this CAD format does not state its unit");
  }
  // A drawing in a length of its own, such as the grain diameter.
  if (is_quantity(table.required_text("length_unit", "mm")))
    return table.required_quantity("length_unit", kUnit);
  return table.required_choice("length_unit", length_units());
}

std::optional<double> read_chord_tolerance(TableReader& table, const geometry::CadFormat& format) {
  const auto tolerance = table.quantity("chord_tolerance", kChordTolerance);
  if (tolerance && format.surface == geometry::SurfaceKind::kTriangles)
    table.reject(
        "chord_tolerance",
        "this file already contains triangles; only STEP and IGES have curved surfaces; remove the key");
  return tolerance;
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

ToolSpec read_tool(TableReader& document, TableReader& table, const WallSpec& walls,
                   const PowderSpec& powder) {
  ToolSpec tool;
  tool.line = table.line();
  tool.name = table.required_name("name", "die");
  tool.role = table.required_choice("role", roles());
  tool.file = read_file(table);
  const geometry::CadFormat& format = *geometry::cad_format(tool.file);
  if (table.has("part")) tool.part = table.required_text("part", "lower punch");
  tool.metres_per_unit = read_length_unit(table, format);
  tool.chord_tolerance = read_chord_tolerance(table, format);
  tool.repair = table.choice("repair", repair_levels()).value_or(geometry::RepairLevel::kSafe);
  tool.mirror = table.direction("mirror").value_or(Eigen::Vector3d::Zero());
  tool.rotation = read_rotation(table);
  tool.position = table.point("position", kPosition).value_or(Eigen::Vector3d::Zero());
  tool.walls = table.choice("walls", wall_kinds());
  tool.sphere_radius = table.quantity("sphere_radius", kWallSphereRadius);
  tool.spacing = table.number("spacing", kWallSpacing);
  tool.friction = table.number("friction", kWallFriction);
  tool.work_of_adhesion = table.quantity("work_of_adhesion", kWallAdhesion);
  tool.contact = read_tool_contact(document, table, tool, powder, walls);
  table.finish();
  if (tool.walls.value_or(walls.kind) == WallKind::spheres)
    check_wall_is_tight(table, tool.sphere_radius.value_or(walls.sphere_radius),
                        tool.spacing.value_or(walls.spacing), powder);
  return tool;
}

}  // namespace

std::vector<ToolSpec> read_tools(TableReader& document, const WallSpec& walls, const PowderSpec& powder) {
  std::vector<ToolSpec> tools;
  document.require("tool", "a [[tool]] table with name, role, file and length_unit");
  for (TableReader& table : document.tables("tool")) {
    ToolSpec tool = read_tool(document, table, walls, powder);
    const auto same = [&tool](const ToolSpec& other) { return other.name == tool.name; };
    const auto earlier = std::find_if(tools.begin(), tools.end(), same);
    if (earlier != tools.end()) {
      table.reject("name", "the tool on line " + std::to_string(earlier->line) +
                               " already has this name; give each tool a unique name");
    }
    tools.push_back(std::move(tool));
  }
  if (tools.empty()) document.reject("tool", "expected at least one [[tool]] table");
  return tools;
}

std::string description(ToolRole role) {
  for (const auto& [word, value] : roles()) {
    if (value == role) return word;
  }
  throw std::logic_error("a tool role without a word");
}

}  // namespace diefill::process
