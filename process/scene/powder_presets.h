// Powders with published parameters (Bierwisch 2009, Tables 4.2, C.4 and C.6).
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process {

/// Names of all presets, as a scene spells them.
std::vector<std::string> preset_names();

/// The preset of that name, at its reference grain size. Throws std::invalid_argument for another name.
PowderSpec powder_preset(const std::string& name);

/// m, the grain size as the tables print it: 0.47 mm for model D, where 6R is 0.4704 mm (Table C.4).
double nominal_grain_diameter(GrainModel model);

/// m, basic sphere radius R of a grain model at the reference size; all models have the same solid volume
/// (Table C.4).
double reference_sphere_radius(GrainModel model);

}  // namespace diefill::process
