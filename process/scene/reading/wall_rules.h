// What a wall may be, for [walls] and for a tool that differs from it.
#pragma once

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

inline constexpr QuantityRule kWallSphereRadius = {Dimension::length, "0.15 mm", "0.001 mm", "10 mm"};
/// Below 0.2, the least that a cover is made with (geometry/wall_spheres), a wall would take tens of spheres
/// where one does; above 4 the spheres stand apart.
inline constexpr NumberRule kWallSpacing = {0.2, 4, false, "1.6"};

inline constexpr NumberRule kWallFriction = {0, 10, false, "0.15"};
inline constexpr QuantityRule kWallAdhesion = {Dimension::work_of_adhesion, "0 J/m^2", "0 J/m^2", "10 J/m^2"};

inline const Choices<WallKind>& wall_kinds() {
  static const Choices<WallKind> choices = {{"spheres", WallKind::spheres}, {"mesh", WallKind::mesh}};
  return choices;
}

}  // namespace diefill::process
