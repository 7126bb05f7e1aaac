// What lies in the zones of a part over time, at the instants that a run keeps.
#pragma once

#include <vector>

#include "process/measure/figures/zone.h"

namespace diefill::process {

/// One table a zone, named "zone <name>": time (s), mass (kg), share of the powder in the cavity, and solid
/// fraction at every kept instant and at the end, as add_zone_figures() has them; NaN where there is no
/// value. The cavity is where it is at the end. None where nothing but the end is kept.
std::vector<results::ProbeSeries> zone_histories(const results::FillResult& result,
                                                 const std::vector<Zone>& zones);

}  // namespace diefill::process
