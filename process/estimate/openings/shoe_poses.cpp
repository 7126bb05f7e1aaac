#include "process/estimate/openings/shoe_poses.h"

#include <algorithm>

#include "process/estimate/openings/motion_times.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

constexpr int kDense = 400;        // instants of a step
constexpr double kShaking = 0.01;  // m, beyond which a motion about one place carries the shoe about

std::vector<ShoePose> poses_at(const std::vector<double>& times, const Stages& stages,
                               const std::vector<StepState>& states, const std::string& die,
                               const std::string& shoe) {
  std::vector<ShoePose> poses;
  for (const double time : times) {
    const ToolPose below = pose_of(stages, states, die, time), above = pose_of(stages, states, shoe, time);
    const Eigen::Matrix3d turn = above.rotation.transpose() * below.rotation;
    const Eigen::Vector3d shift = below.rotation.transpose() * (above.translation - below.translation);
    poses.push_back({time, turn.topLeftCorner<2, 2>(), shift.head<2>()});
  }
  return poses;
}

/// m, by which two courses of poses are apart at most.
double farthest_apart(const std::vector<ShoePose>& one, const std::vector<ShoePose>& other) {
  double farthest = 0;
  for (std::size_t k = 0; k < one.size(); ++k)
    farthest = std::max(farthest, (one[k].shift - other[k].shift).norm());
  return farthest;
}

}  // namespace

std::vector<ShoePose> shoe_poses(const Scene& scene, const Tooling& tooling, const std::string& shoe) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const std::string& die = tooling.tools[tooling.die].spec.name;
  const auto times = motion_times(stages, states, kDense);
  auto poses = poses_at(times, stages, states, die, shoe);
  Stages carrying = stages;
  carrying.steps.clear();
  std::vector<StepState> carrying_states;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages.steps[k]->stays()) continue;
    carrying.steps.push_back(stages.steps[k]);
    carrying_states.push_back(states[k]);
  }
  if (carrying.size() == stages.size()) return poses;
  auto carried = poses_at(times, carrying, carrying_states, die, shoe);
  return farthest_apart(poses, carried) <= kShaking ? carried : poses;
}

bool pours_until_at_rest(const Scene& scene) {
  if (scene.pour.grains_file || scene.pour.state || scene.gravity.isZero()) return false;
  const Stages stages(scene);
  // The settling of the poured powder: the first stage, or the scene's own one after an empty first.
  const auto is_settling = [](const Step& step) { return step.open_ended() && step.tools().empty(); };
  return is_settling(*stages.steps[0]) || (!scene.steps.empty() && is_settling(*scene.steps.front()) &&
                                           scene.steps.front()->inflow() == nullptr);
}

bool is_shaken(const Scene& scene, const std::string& shoe, double from, double to) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const auto tools = stages.steps[k]->tools();
    const bool of_shoe = std::find(tools.begin(), tools.end(), shoe) != tools.end();
    if (of_shoe && stages.steps[k]->stays() && states[k].started < to && states[k].ended > from) return true;
  }
  return false;
}

}  // namespace diefill::process::estimate
