// Covers tools with wall spheres that have been read already.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// As build_tooling() does, of tools that read_tooling() has read already, for this scene or for one that
/// differs from it only in the numbers of a setting.
Tooling cover_tooling(const Scene& scene, Tooling read, double smallest_radius, double grain_diameter,
                      const ProgressCallback& on_progress = ignore_progress);

}  // namespace diefill::process
