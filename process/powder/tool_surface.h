// What a tool's surface does to the powder: friction and adhesion of [walls], or a tool's own, such as those
// of a polished punch or a worn shoe.
#pragma once

#include <string>

#include "process/scene/scene.h"

namespace diefill::process {

/// Coefficient of Coulomb friction between grains and the tool, without [contact].
double friction_of(const Scene& scene, const ToolSpec& tool);

/// J/m^2, work of adhesion between grains and the tool, without [contact].
double adhesion_of(const Scene& scene, const ToolSpec& tool);

/// True if the tool differs from [walls].
bool has_own_surface(const ToolSpec& tool);

/// Name of the tool's material in the contact laws: engine::kWallMaterial unless it has a surface of its own.
std::string material_of(const ToolSpec& tool);

}  // namespace diefill::process
