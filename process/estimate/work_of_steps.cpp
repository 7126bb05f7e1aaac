#include "process/estimate/work_of_steps.h"

#include <cmath>

#include "process/machine/motions/passage.h"
#include "process/tooling/busy_time.h"

namespace diefill::process::estimate {

std::optional<double> cycle_time(const Scene& scene) {
  if (scene.steps.empty()) return std::nullopt;
  const Stages stages(scene);
  return busy_time(stages, predicted(stages, kSettlingGuess));
}

double Crossing::time_at(double other) const {
  const double way = time >= 2 * speed / acceleration ? speed * (time - speed / acceleration)
                                                      : 0.25 * acceleration * time * time;
  const bool cruises = way >= other * other / acceleration;
  return cruises ? way / other + other / acceleration : 2 * std::sqrt(way / acceleration);
}

std::optional<Crossing> crossing_of(const Scene& scene, const std::string& tool) {
  for (const auto& step : scene.steps) {
    const auto* passage = dynamic_cast<const Passage*>(step.get());
    if (passage == nullptr || passage->spec().tool != tool) continue;
    const int crossings = passage->spec().passages;
    return Crossing{(*passage->duration() - (crossings - 1) * passage->spec().pause) / crossings,
                    passage->spec().velocity, passage->spec().acceleration};
  }
  return std::nullopt;
}

}  // namespace diefill::process::estimate
