#include "process/machine/steady_watch.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

void SteadyWatch::add(const SteadyRule& rule, double coordinate, double resistance, double interval) {
  sum += resistance * interval;
  lasted += interval;
  if (coordinate - from < rule.over) return;
  const double now = sum / lasted;
  if (stretches > 0 && std::abs(now - mean) <= rule.within * std::max(std::abs(now), std::abs(mean)))
    steady = 1;
  *this = {coordinate, 0, 0, now, stretches + 1, steady};
}

}  // namespace diefill::process
