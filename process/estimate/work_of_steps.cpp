#include "process/estimate/work_of_steps.h"

#include <algorithm>
#include <vector>

#include "process/machine/motions/passage.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

std::optional<double> cycle_time(const Scene& scene) {
  if (scene.steps.empty()) return std::nullopt;
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  std::vector<std::pair<double, double>> busy;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const Step& step = *stages.steps[k];
    if (states[k].is_pending() || (step.tools().empty() && !step.duration())) continue;
    busy.emplace_back(states[k].started, std::max(states[k].started, states[k].ended));
  }
  std::sort(busy.begin(), busy.end());
  double time = 0, counted = 0;
  for (const auto& [start, end] : busy) {
    time += std::max(0.0, end - std::max(start, counted));
    counted = std::max(counted, end);
  }
  return time;
}

std::optional<double> crossing_time(const Scene& scene, const std::string& tool) {
  for (const auto& step : scene.steps) {
    const auto* passage = dynamic_cast<const Passage*>(step.get());
    if (passage == nullptr || passage->spec().tool != tool) continue;
    const int crossings = passage->spec().passages;
    return (*passage->duration() - (crossings - 1) * passage->spec().pause) / crossings;
  }
  return std::nullopt;
}

}  // namespace diefill::process::estimate
