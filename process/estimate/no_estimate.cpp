#include "process/estimate/no_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/machine/actions/powder_change.h"
#include "process/results/formatted.h"
#include "process/tooling/examination/shoe_floor.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

constexpr double kWeak = 0.01;  // m/s^2, below which powder may never come to rest (process/scene/README.md)
constexpr double kSame = 1e-3;  // of gravity, which a step leaves as it was

constexpr const char* kHolds = "the formulas hold for steady gravity along -z; simulate";

std::string vector_text(const Eigen::Vector3d& gravity) {
  return results::formatted("(%.3g, %.3g, %.3g) m/s^2", gravity.x(), gravity.y(), gravity.z());
}

/// Why the formulas do not hold under `gravity` (m/s^2); empty: they do.
std::string gravity_fault(const Eigen::Vector3d& gravity) {
  if (gravity.norm() < kWeak)
    return results::formatted("gravity is %.3g m/s^2, less than %.3g, so that powder does not fall, and ",
                              gravity.norm(), kWeak) +
           kHolds;
  const double off = std::acos(std::clamp(-gravity.z() / gravity.norm(), -1.0, 1.0)) * 180 / std::numbers::pi;
  if (off <= kLargestTilt) return {};
  return "gravity " + vector_text(gravity) +
         results::formatted(" acts %.3g degrees off -z, at most %.2g, and ", off, kLargestTilt) + kHolds;
}

/// Whether a tool moves after `time` (s).
bool tools_move_after(double time, const Stages& stages, const std::vector<StepState>& states) {
  for (std::size_t k = 0; k < stages.size(); ++k)
    if (!stages.steps[k]->tools().empty() && states[k].ended > time) return true;
  return false;
}

/// Why gravity that a step changes leaves the formulas without an answer; empty: none does, or only once all
/// tools stand.
std::string changed_gravity(const Scene& scene) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const PowderChange* change = stages.steps[k]->change();
    if (change == nullptr || !change->gravity) continue;
    if ((*change->gravity - scene.gravity).norm() <= kSame * scene.gravity.norm()) continue;
    if (tools_move_after(states[k].started, stages, states))
      return "a step changes gravity from " + vector_text(scene.gravity) + " to " +
             vector_text(*change->gravity) + " while tools still move, and " + kHolds;
  }
  return {};
}

}  // namespace

bool is_not_estimated(const Scene& scene, const Tooling& tooling, Estimate& estimate) {
  std::string why = gravity_fault(scene.gravity);
  if (why.empty()) why = changed_gravity(scene);
  if (!why.empty()) {
    estimate.answer = Answer::no_formula;
    estimate.open_because = {why};
    return true;
  }
  for (const Tool& tool : tooling.tools) {
    if (tool.spec.role != ToolRole::shoe) continue;
    const auto floor = closed_floor(scene, tool);
    if (!floor) continue;
    estimate.answer = Answer::shut;
    estimate.open_because = {closed_floor_text(tool, *floor)};
    return true;
  }
  return false;
}

}  // namespace diefill::process::estimate
