#include "process/estimate/discharge/filling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::process::estimate {

namespace {

double slows_below(const FillSpace& space) {
  return std::min(space.depth, kSlowsBelow * space.width);
}

}  // namespace

double filled_height(const FillSpace& space, double offered) {
  const double reach = slows_below(space), free = space.depth - reach;
  if (offered <= free) return offered;
  if (!(reach > 0)) return space.depth;
  return space.depth - reach * std::exp(-(offered - free) / reach);
}

double offered_for(const FillSpace& space, double height) {
  const double reach = slows_below(space), free = space.depth - reach;
  if (height <= free) return height;
  if (height >= space.depth) return std::numeric_limits<double>::infinity();
  return free - reach * std::log((space.depth - height) / reach);
}

}  // namespace diefill::process::estimate
