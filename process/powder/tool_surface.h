// What a tool's surface does to the powder: friction and adhesion of [walls], or a tool's own, such as those
// of a polished punch or a worn shoe.
#pragma once

#include <string>

#include "engine/simulation/simulation.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Material, in the laws of a mix, of tools that are as [walls] says.
inline constexpr const char* kWallMaterial = "tools";

/// Coefficient of Coulomb friction between grains and the tool.
double friction_of(const Scene& scene, const ToolSpec& tool);

/// J/m^2, work of adhesion between grains and the tool.
double adhesion_of(const Scene& scene, const ToolSpec& tool);

/// True if the tool differs from [walls] in either.
bool has_own_surface(const ToolSpec& tool);

/// `walls`, the contact of grains with tools in general, with the friction and adhesion of this one.
engine::ContactParameters contact_with(const Scene& scene, const ToolSpec& tool,
                                       engine::ContactParameters walls);

/// The same for a law in parts: Bierwisch's, since [contact] gives all tools one law.
engine::laws::LawParameters contact_with(const Scene& scene, const ToolSpec& tool,
                                         engine::laws::LawParameters walls);

/// Name of the tool's material in the laws of a mix.
std::string material_of(const ToolSpec& tool);

}  // namespace diefill::process
