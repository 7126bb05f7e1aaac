// Where powder is computed: grains beyond have been spilled or discharged.
#pragma once

#include "process/run/schedule.h"

namespace diefill::process {

/// m, box round all that tools reach in the schedule, no larger than the tools that stay at their place with
/// two grain diameters of room; open upwards, along periods, and, unless economy.drop_spilled, half a metre
/// down and to all sides.
geometry::Box powder_domain(const Scene& scene, const Tooling& tooling, const Schedule& schedule);

}  // namespace diefill::process
