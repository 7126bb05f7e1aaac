// What a plant can measure and vary, and which values a measured figure can have: what no run and no plant
// can give is a mistake in the file.
#pragma once

#include <string>

#include "process/measured_data/known_fields.h"

namespace diefill::process::calibration {

/// Of the figure or quantity of the trade-off of that name, in its unit.
PossibleValues possible_values_of_figure(const std::string& name, const std::string& unit);

/// Of a quantity of an experiment of the laboratory: by `id`, what it is called and its unit. No density
/// exceeds that of the solid, `solid_density` in kg/m^3; 0: not known.
PossibleValues possible_values_of_experiment(const std::string& id, const std::string& called,
                                             const std::string& unit, double solid_density);

/// Whether the figure tells of the computation, such as its steps or its time, and not of powder or die.
bool is_of_computation(const std::string& figure);

/// Whether an experiment can vary the key of a scene: not title, seed, setting and numerics.
bool can_be_varied(const std::string& key);

}  // namespace diefill::process::calibration
