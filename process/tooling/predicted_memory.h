// Memory that a run takes, fitted to measured runs.
#pragma once

namespace diefill::process::plan {

/// Peak memory (bytes) of `diefill run` with so many spheres of grains and of tools.
double predicted_memory(double spheres, double wall_spheres);

}  // namespace diefill::process::plan
