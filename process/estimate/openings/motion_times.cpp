#include "process/estimate/openings/motion_times.h"

#include <algorithm>

#include "process/machine/motions/passage.h"

namespace diefill::process::estimate {

std::vector<double> motion_times(const Stages& stages, const std::vector<StepState>& states, int dense) {
  constexpr int kOfACrossing = 50;  // instants
  auto times = instants(stages, states, dense);
  times.push_back(0);
  // The settling of the poured powder is the first stage, or the second after an empty first.
  for (std::size_t k = 0; k < std::min<std::size_t>(2, stages.size()); ++k) times.push_back(states[k].ended);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages.steps[k]->tools().empty() || states[k].is_pending()) continue;
    times.push_back(states[k].started);
    const auto* passage = dynamic_cast<const Passage*>(stages.steps[k].get());
    const int count = passage == nullptr ? 0 : kOfACrossing * passage->spec().passages;
    if (count <= dense) continue;
    const double apart = (states[k].ended - states[k].started) / count;
    for (int n = 1; n < count; ++n) times.push_back(states[k].started + n * apart);
  }
  std::erase_if(times, [](double time) { return time < 0; });  // of steps that never begin
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace diefill::process::estimate
