// A run under way in a few numbers, for pages that show its progress. Does not change the run: it computes
// the same bits.
#pragma once

#include <string>
#include <vector>

#include "process/results/margins.h"
#include "process/run/fill_run.h"

namespace diefill::process {

/// How far the run is and how it goes.
struct LiveState {
  double time = 0;            ///< s of the scene
  double share = 0;           ///< of the scene that is over, 0 to 1, as far as can be predicted
  double filled_mass = 0;     ///< kg of model powder in all cavities
  double kinetic_energy = 0;  ///< J, of all grains
  double sphere_steps_per_second = 0;
  std::uint64_t grains = 0;
  std::string stage;  ///< for people
  std::vector<results::Margin> margins;
};

/// Takes a pass over the grains and one over the contacts.
LiveState live_state(const Tooling& tooling, const FillRun& run);

}  // namespace diefill::process
