#include "process/powder/tool_surface.h"

#include "engine/powder/materials.h"

namespace diefill::process {

double friction_of(const Scene& scene, const ToolSpec& tool) {
  return tool.friction.value_or(scene.walls.friction);
}

double adhesion_of(const Scene& scene, const ToolSpec& tool) {
  return tool.work_of_adhesion.value_or(scene.walls.work_of_adhesion);
}

bool has_own_surface(const ToolSpec& tool) {
  return tool.friction || tool.work_of_adhesion || tool.contact;
}

std::string material_of(const ToolSpec& tool) {
  return has_own_surface(tool) ? "tool " + tool.name : engine::kWallMaterial;
}

}  // namespace diefill::process
