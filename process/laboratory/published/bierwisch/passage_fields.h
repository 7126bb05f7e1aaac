// Smooth fields of powder at several instants of a passage, at rest with the die (Bierwisch 2009, Eq. 2.27).
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/scene_experiment.h"
#include "process/measure/fields/gaussian_field.h"

namespace diefill::process::laboratory {

/// Means over the grains of all instants.
struct PassageFields {
  GaussianField speed;     ///< magnitude of the velocity over that of the shoe
  GaussianField fraction;  ///< solid fraction over that of the powder settled in the shoe
  double width;            ///< m, sigma of both averages
};

/// Of `run` at the snapshots `instants`; the settled powder is that of the snapshot "settled". `speed`: m/s,
/// of the shoe. sigma is 0.5 mm as published, but half a grain at least. Grains with open cells are no part
/// of the fraction.
PassageFields passage_fields(const SeedResults& seed, const std::string& run,
                             const std::vector<std::string>& instants, double speed);

}  // namespace diefill::process::laboratory
