// How long the machine is at work in a scene, before it runs.
#pragma once

#include <optional>
#include <string>

#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// s that a step is on which moves a tool or lasts a given time, as the run's figure `cycle_time_s`, with
/// powder that rests at once; nothing without steps. `scene` has prepared steps.
std::optional<double> cycle_time(const Scene& scene);

/// s of one crossing of the scene's first passage of that tool; nothing where there is none.
std::optional<double> crossing_time(const Scene& scene, const std::string& tool);

}  // namespace diefill::process::estimate
