// How long the machine is at work in a scene, before it runs.
#pragma once

#include <optional>
#include <string>

#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// s that a step is on which moves a tool or lasts a given time, as the run's figure `cycle_time_s`, with
/// powder that rests at once; nothing without steps. `scene` has prepared steps.
std::optional<double> cycle_time(const Scene& scene);

/// One crossing of a passage.
struct Crossing {
  double time = 0;          ///< s, without pauses
  double speed = 0;         ///< m/s, once accelerated
  double acceleration = 0;  ///< m/s^2, also of braking

  /// s, of the same way at another speed (m/s).
  double time_at(double other) const;
};

/// Of the scene's first passage of that tool; nothing where there is none.
std::optional<Crossing> crossing_of(const Scene& scene, const std::string& tool);

}  // namespace diefill::process::estimate
