// Velocities and displacements: a magnitude in colour with arrows on it.
#pragma once

#include "process/results/arrow_field.h"
#include "render/fields/density_map.h"

namespace diefill::render {

/// Scales that pictures of several runs have in common, in the unit of their arrows.
struct ArrowScale {
  double upper = 1;         ///< end of the colour scale, which begins at 0
  double arrow_length = 0;  ///< value of the arrow in the legend
};

/// From the magnitudes and arrows of all, which have one unit.
ArrowScale common_scale(const std::vector<results::ArrowField>& all);

/// `quantity` names what the arrows are, such as "displacement". `upper`: end of the colour scale, which
/// begins at 0; NaN: from the data.
FieldPicture compose_arrows(const results::ArrowField& arrows, const std::string& quantity,
                            const std::string& title, const std::string& subtitle, double upper,
                            FieldStyle style);

}  // namespace diefill::render
