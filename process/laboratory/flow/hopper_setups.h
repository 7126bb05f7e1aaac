// Set-ups of the hopper of Bierwisch 2009, section 5.1 (Tables 5.1 and C.5), for grains coarser than the
// source's.
#pragma once

#include <vector>

#include "process/laboratory/experiment.h"
#include "process/laboratory/flow/hopper_run.h"

namespace diefill::process::laboratory {

/// Set-up 1 with grains `factor` times as large as the source's: model D, friction 0.5, no cohesion, a slit
/// of 15 mm. Slit and depth are the source's until fit_to_grains.
HopperSetup source_hopper(double factor);

/// Slit and depth for the set-up's grains, `factor` times as large as the source's: the slit is wider by
/// kEmptyAnnulus times what the grains have grown by, depths grow with the grains.
void fit_to_grains(double factor, HopperSetup& setup);

/// m/s, sqrt(g D).
double speed_scale(const HopperSetup& setup);

/// Fields of each set-up, the mean of `packings` runs of different seeds.
std::vector<HopperFields> run_packings(const ExperimentOptions& options,
                                       const std::vector<HopperSetup>& setups, int packings);

}  // namespace diefill::process::laboratory
