// A dense bed at rest under gravity, then set in motion without dissipation.
#pragma once

#include "engine/powder/new_grain.h"
#include "engine/simulation/settings.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

struct UndampedBed {
  engine::ContactParameters contact;    ///< of grains and floor, undamped
  engine::SimulationSettings settings;  ///< undamped
  std::vector<engine::NewGrain> grains;
  double eigenfrequency = 0;  ///< rad/s, largest of the contact network
};

/// `across`^2 x `layers` grains that have fallen onto a flat floor and lost their energy to damping. With
/// `friction` contacts hold tangential springs of kappa_t = 1e6 Pa R.
UndampedBed undamped_bed(const engine::GrainShape& shape, double friction, int across, int layers);

/// Spurious energy gain in `steps` steps of `time_step` (s), without damping and after every grain got random
/// 1 mm/s, over the elastic and kinetic energy at the start.
double bed_energy_growth(const UndampedBed& pile, double time_step, long steps);

}  // namespace diefill::process::laboratory
