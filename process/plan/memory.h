// How much memory a run takes, from what was measured of finished ones.
#pragma once

namespace diefill::process::plan {

/// Peak memory (bytes) of `diefill run` with so many spheres of grains, of one size or several, and of tools.
double predicted_memory(double spheres, double wall_spheres, bool several_sizes = false);

}  // namespace diefill::process::plan
