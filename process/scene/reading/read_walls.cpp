#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"
#include "process/scene/reading/wall_rules.h"

namespace diefill::process {
WallSpec read_walls(TableReader table, const PowderSpec& powder) {
  static const Choices<MeshContactRadius> radii = {{"flat", MeshContactRadius::flat},
                                                   {"wall spheres", MeshContactRadius::wall_spheres}};
  WallSpec walls;
  walls.kind = table.choice("kind", wall_kinds()).value_or(walls.kind);
  walls.contact_radius = table.choice("contact_radius", radii).value_or(walls.contact_radius);
  walls.sphere_radius = table.quantity("sphere_radius", kWallSphereRadius).value_or(walls.sphere_radius);
  walls.spacing = table.number("spacing", kWallSpacing).value_or(walls.spacing);
  walls.friction = table.number("friction", kWallFriction).value_or(walls.friction);
  walls.work_of_adhesion = table.quantity("work_of_adhesion", kWallAdhesion).value_or(walls.work_of_adhesion);
  table.finish();
  if (walls.kind == WallKind::spheres) check_wall_is_tight(table, walls.sphere_radius, walls.spacing, powder);
  return walls;
}

}  // namespace diefill::process
