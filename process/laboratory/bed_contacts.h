// Contact statistics of a bed: overlaps and coordination numbers.
#pragma once

#include "process/laboratory/settled_bed.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process::laboratory {

/// Fills in the histogram of overlaps h / d over sphere contacts between grains (20 logarithmic bins a
/// decade), its peak and mean, and the mean coordination number (distinct touching grains; the ground does
/// not count) of grains at least 2 d from top and bottom.
void contact_figures(const engine::Simulation& simulation, double grain_diameter, BedFigures& figures);

}  // namespace diefill::process::laboratory
