#include "process/scene/walls_without_effect.h"

#include <toml++/toml.h>

#include <algorithm>

#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

WallKind kind_of(const Scene& scene, const ToolSpec& tool) {
  return tool.walls.value_or(scene.walls.kind);
}

bool has_kind(const Scene& scene, WallKind kind) {
  return std::any_of(scene.tools.begin(), scene.tools.end(),
                     [&](const ToolSpec& tool) { return kind_of(scene, tool) == kind; });
}

}  // namespace

std::vector<std::string> walls_without_effect(const Scene& scene) {
  std::vector<std::string> lines;
  const std::string no_effect = " has no effect on contacts: ";
  const toml::table document = parse_scene_text(scene.text, scene.file);
  if (!has_kind(scene, WallKind::spheres) && document["walls"]["spacing"])
    lines.push_back("walls.spacing" + no_effect +
                    "the walls of all tools are their mesh, without wall spheres");
  if (!has_kind(scene, WallKind::mesh) && document["walls"]["contact_radius"])
    lines.push_back("walls.contact_radius" + no_effect +
                    "it is for walls of kind \"mesh\", and those of all tools are wall spheres");
  for (const ToolSpec& tool : scene.tools)
    if (tool.spacing && kind_of(scene, tool) == WallKind::mesh)
      lines.push_back("spacing of tool \"" + tool.name + "\"" + no_effect +
                      "the wall of this tool is its mesh, without wall spheres");
  return lines;
}

}  // namespace diefill::process
