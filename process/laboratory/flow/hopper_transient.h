// Discharge from the opening of the slit on (Bierwisch 2009, section 5.2.1): powder that has run out of
// hoppers with slits of two widths over time, Eq. 5.15 fitted to all of them together, and the steady rate.
#pragma once

#include <vector>

#include "process/continuum/discharge_fit.h"
#include "process/laboratory/flow/hopper_run.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::process::laboratory {

/// Slits of 10 and 15 mm with grains `factor` times as large as the source's, in hoppers as wide as the
/// shoes of the source: 32 mm, and 45 mm for the widest slit. They flow for about 0.3 s; levels stay above 2
/// D.
std::vector<HopperSetup> transient_setups(double factor);

/// Eq. 5.15 of the powder that has run out of all set-ups. Throws std::invalid_argument where it is none of a
/// flow.
continuum::DischargeFit fit_transient(const std::vector<HopperSetup>& setups,
                                      const std::vector<HopperFields>& fields);

/// E01 to E05, of transient_setups. E01 to E04 have no value where the flow does not determine beta.
std::vector<results::ExperimentFigure> transient_figures(const continuum::DischargeFit& fit,
                                                         const std::vector<HopperSetup>& setups,
                                                         const std::vector<HopperFields>& fields);

}  // namespace diefill::process::laboratory
