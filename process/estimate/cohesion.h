// How strongly grains stick together against their weight.
#pragma once

#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// Bond number of [powder] at its own size: the largest pull of two grains on their first approach over the
/// weight of a grain (Bierwisch 2009, Eq. 2.5), times the factor of coarse graining where [contact] gives the
/// laws of the enlarged grains, as stresses stay the same. Cohesion that only a deformed contact has, as in
/// Luding's law, is not in it. 0 without gravity.
double bond_number(const Scene& scene);

}  // namespace diefill::process::estimate
