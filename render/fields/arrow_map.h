// Velocities and displacements: a magnitude in colour with arrows on it.
#pragma once

#include "process/results/arrow_field.h"
#include "render/fields/density_map.h"

namespace diefill::render {

/// `quantity` names what the arrows are, such as "displacement". `upper`: end of the colour scale, which
/// begins at 0; NaN: from the data.
FieldPicture compose_arrows(const results::ArrowField& arrows, const std::string& quantity,
                            const std::string& title, const std::string& subtitle, double upper,
                            FieldStyle style);

}  // namespace diefill::render
