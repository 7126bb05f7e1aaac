#include "process/tooling/busy_time.h"

#include <algorithm>
#include <utility>

namespace diefill::process {

double busy_time(const Stages& stages, const std::vector<StepState>& states) {
  std::vector<std::pair<double, double>> busy;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const auto duration = stages.steps[k]->duration();
    if (!states[k].has_ended() || (stages.steps[k]->tools().empty() && !duration)) continue;
    // The schedule notices ends a few time steps late.
    const double end = duration ? std::min(states[k].ended, states[k].started + *duration) : states[k].ended;
    busy.emplace_back(states[k].started, end);
  }
  std::sort(busy.begin(), busy.end());
  double time = 0, counted = 0;
  for (const auto& [start, end] : busy) {
    time += std::max(0.0, end - std::max(start, counted));
    counted = std::max(counted, end);
  }
  return time;
}

}  // namespace diefill::process
