#include "process/powder/tool_surface.h"

namespace diefill::process {

namespace laws = engine::laws;

double friction_of(const Scene& scene, const ToolSpec& tool) {
  return tool.friction.value_or(scene.walls.friction);
}

double adhesion_of(const Scene& scene, const ToolSpec& tool) {
  return tool.work_of_adhesion.value_or(scene.walls.work_of_adhesion);
}

bool has_own_surface(const ToolSpec& tool) {
  return tool.friction || tool.work_of_adhesion;
}

engine::ContactParameters contact_with(const Scene& scene, const ToolSpec& tool,
                                       engine::ContactParameters walls) {
  walls.friction = friction_of(scene, tool);
  walls.work_of_adhesion = adhesion_of(scene, tool);
  return walls;
}

laws::LawParameters contact_with(const Scene& scene, const ToolSpec& tool, laws::LawParameters walls) {
  std::get<laws::BierwischNormal::Parameters>(walls.normal.choice).work_of_adhesion =
      adhesion_of(scene, tool);
  std::get<laws::CundallFriction::Parameters>(walls.friction.choice).friction = friction_of(scene, tool);
  return walls;
}

std::string material_of(const ToolSpec& tool) {
  return has_own_surface(tool) ? "tool " + tool.name : kWallMaterial;
}

}  // namespace diefill::process
