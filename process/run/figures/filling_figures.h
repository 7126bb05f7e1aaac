// Figures of a filled die in terms of powder metallurgy.
#pragma once

#include "process/measure/figures/real_mass.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Adds those of the result's cavity: masses and fill ratio (real_mass.h), and how they vary over azimuth and
/// height from the result's profiles.
void add_filling_figures(results::FillResult& result, const Scene& scene, const PowderBed& bed);

/// Adds what is the same for all cavities: shoe speed, coarse graining, density of the bed.
void add_powder_figures(results::FillResult& result, const Scene& scene, const PowderBed& bed);

}  // namespace diefill::process
