// Which measured profiles and maps a die can have: some are of rings alone, some of all other cavities.
#pragma once

#include <string>
#include <vector>

#include "process/measured_data/measured_table.h"

namespace diefill::process {

/// Throws SceneError, in one line with the places that are allowed, for a measured profile (one place) or map
/// (two) of `quantity`, such as "fill level, cavity 2", that results of such a die never have. `rings`:
/// whether each cavity is a ring, the largest first.
void refuse_field_of_other_shape(const MeasuredTable& table, const std::string& quantity,
                                 const std::vector<bool>& rings);

/// The same for a quantity that is no profile, map or section of any result. `sections`: names of those of
/// the scene.
void refuse_unknown_field(const MeasuredTable& table, const std::vector<std::string>& sections);

/// "but the die has one cavity".
std::string but_the_die_has(std::size_t cavities);

}  // namespace diefill::process
