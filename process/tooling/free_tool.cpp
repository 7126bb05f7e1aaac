#include "process/tooling/free_tool.h"

#include "geometry/mesh/mass_properties.h"
#include "process/machine/free_motion.h"

namespace diefill::process {

engine::FreeBodySpec free_body_of(const Tooling& tooling, const Step& step) {
  const FreeMotion& free = *free_motion_of(step);
  engine::FreeBodySpec spec = free.body;
  spec.body = tooling.index_of(step.tools().front());
  const geometry::MassProperties solid = geometry::mass_properties(tooling.tools[spec.body].mesh);
  if (free.density > 0) spec.mass = free.density * solid.volume;
  spec.centre = solid.centre;
  spec.inertia = spec.mass / solid.volume * solid.inertia;
  return spec;
}

}  // namespace diefill::process
