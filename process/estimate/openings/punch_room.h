// The room that falling punches make below an opening while powder stands over it.
#pragma once

#include <vector>

#include "process/estimate/discharge/inflow.h"

namespace diefill::process::estimate {

/// How far the punches below one opening are when a crossing of the shoe ends.
struct PunchRoom {
  double share = 1;    ///< room that there is by then, of that which the steps leave
  double made = 0;     ///< m^3, made by then below powder
  double running = 0;  ///< m^3 that powder would have run through by its weight meanwhile
};

/// By crossing, of opening `opening`; a punch is taken to fall steadily.
std::vector<PunchRoom> punch_room(const OpeningLayout& layout, const ShoePath& path,
                                  const InflowPowder& powder, std::size_t opening);

/// Share of a punch's room that it makes while powder stands over it.
double covered_share(const OpeningLayout& layout, const ShoePath& path, std::size_t punch);

/// m/s, at which powder runs through an opening of this effective width in the long run.
double running_speed(const InflowPowder& powder, double width);

}  // namespace diefill::process::estimate
