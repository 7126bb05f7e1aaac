// What a profile of a result may be called, and the places that it may be asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// "fill level" and "fill level over azimuth"; of a profile along the travel of the shoe also "fill level
/// over x" and "over y".
std::vector<std::string> names_of(const results::Profile& profile);

/// Whether the profile runs along the travel of the shoe.
bool runs_along_travel(const results::Profile& profile);

/// m: position along x or y of the scene, as a distance along the travel of the shoe in this cavity. Nothing
/// for other places, and for the axis that the shoe does not travel along.
std::optional<double> distance_along_travel(const std::string& place, double position,
                                            const results::CavityState& cavity);

}  // namespace diefill::process
