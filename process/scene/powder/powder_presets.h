// Powders with published parameters (Bierwisch 2009, Tables 4.2, C.4 and C.6).
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process {

/// Names of all presets, as a scene spells them, those for die filling first.
std::vector<std::string> preset_names();

/// Use and limits of a preset, as text.
struct PresetUse {
  std::string name;
  std::string use;        ///< what it may be used for
  std::string limits;     ///< known deviations
  std::string fitted_to;  ///< the experiment that its parameters come from
};

/// In the order of preset_names().
std::vector<PresetUse> preset_uses();

/// kg/m^3, of the metal of a preset's powder, which is iron: the tabulated grain masses make model grains
/// lighter. 0 for user-defined powders, and where the scene gives the mass of a grain.
double preset_solid_density(const PowderSpec& powder);

/// One-line warning for a preset that is unsuitable for die filling; empty for all others.
std::string preset_warning(const PowderSpec& powder);

/// The preset of that name, at its reference grain size. Throws std::invalid_argument for another name.
PowderSpec powder_preset(const std::string& name);

}  // namespace diefill::process
