// Charts of the hopper, as Bierwisch 2009, Figs. 5.5 to 5.9, has them.
#pragma once

#include <vector>

#include "process/laboratory/experiment.h"
#include "process/laboratory/flow/hopper_models.h"

namespace diefill::process::laboratory {

/// Local B over the solid fraction: a share of all nodes, means of classes, the fit and the published one.
results::ExperimentChart length_chart(const std::vector<continuum::LengthPoint>& points,
                                      const continuum::LengthOfFraction& fitted);

/// Local B over x at six heights, where |v_x| is above 0.02 sqrt(gD) as in Bierwisch 2009, Fig. 5.5, and B
/// positive.
results::ExperimentChart length_field_chart(const HopperSetup& setup, const HopperFields& fields);

/// The kinematic model with a constant length, and the compressible one.
struct HopperModels {
  const continuum::HopperFlow* incompressible;
  const continuum::HopperFlow* compressible;
};
/// Profiles of both velocities over x at 0.25, 0.5, 0.75, 1, 1.5 and 2 times `width` (m) above the slit.
void add_profile_charts(const HopperFields& fields, double width, const HopperModels& models,
                        std::vector<results::ExperimentChart>& charts);

/// Velocities over sqrt(gD) against x over D of all set-ups, low and high above the slit. `widths` D in
/// m, `scales` in m/s, by set-up.
void add_scaling_charts(const std::vector<HopperSetup>& setups, const std::vector<HopperFields>& fields,
                        const std::vector<double>& widths, const std::vector<double>& scales,
                        std::vector<results::ExperimentChart>& charts);

}  // namespace diefill::process::laboratory
