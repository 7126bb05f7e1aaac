// What running a scene will take: grains, spheres, steps, memory and, with a pilot run, time.
#pragma once

#include <optional>
#include <vector>

#include "process/plan/timeline.h"

namespace diefill::process::plan {

struct Pilot;  // pilot.h

/// One phase with what it costs.
struct PhaseForecast {
  Phase phase;
  double steps = 0;         ///< time steps
  double sphere_steps = 0;  ///< spheres times steps
  double wall_seconds = 0;  ///< 0: not known
};

/// Figures of a run to come. SI units.
struct Forecast {
  double grain_diameter = 0, fill_height = 0;  ///< m
  double time_step = 0, critical_step = 0;     ///< s
  std::size_t grains = 0, spheres = 0;         ///< poured
  std::size_t wall_spheres = 0;
  std::vector<PhaseForecast> phases;
  double memory = 0;                   ///< bytes, peak of the program
  std::optional<double> wall_seconds;  ///< of computing; nothing without a pilot

  double steps() const;
  double sphere_steps() const;
  double seconds() const;  ///< simulated
};

/// The scene as it stands, on its tooling. Nothing is simulated.
Forecast forecast(const Scene& scene, const Tooling& tooling, const RestTimes& rest = {});

/// The same, with the time that each phase takes at the pilot's cost of a sphere and step.
Forecast forecast(const Scene& scene, const Tooling& tooling, const Pilot& pilot);

}  // namespace diefill::process::plan
