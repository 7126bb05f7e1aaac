#include "process/estimate/work_of_steps.h"

#include "process/machine/motions/passage.h"
#include "process/tooling/busy_time.h"

namespace diefill::process::estimate {

std::optional<double> cycle_time(const Scene& scene) {
  if (scene.steps.empty()) return std::nullopt;
  const Stages stages(scene);
  return busy_time(stages, predicted(stages, kSettlingGuess));
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
