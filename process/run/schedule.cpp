#include "process/run/schedule.h"

#include <algorithm>

#include "process/machine/settle.h"

namespace diefill::process {

namespace {

engine::BodyMotion body_motion(const ToolPose& pose) {
  return {pose.rotation, pose.translation, pose.velocity, pose.angular_velocity};
}

ToolPose standing_still(ToolPose pose) {
  pose.velocity.setZero();
  pose.angular_velocity.setZero();
  return pose;
}

}  // namespace

Schedule::Schedule(const Scene& scene, const Tooling& tooling, double grain_diameter)
    : tooling_(tooling), grain_diameter_(grain_diameter) {
  stages_.push_back(std::make_shared<Settle>(std::nullopt));
  stages_.insert(stages_.end(), scene.steps.begin(), scene.steps.end());
  if (stages_.back()->duration()) stages_.push_back(std::make_shared<Settle>(std::nullopt));
}

void Schedule::begin(engine::Simulation& simulation, const ScheduleState& state) {
  state_ = state;
  set_motions(simulation);
}

bool Schedule::update(engine::Simulation& simulation) {
  if (finished()) return false;
  const auto duration = stages_[state_.stage]->duration();
  const bool over = duration ? simulation.time() - state_.stage_start >= *duration
                             : state_.rest.at_rest(simulation, grain_diameter_);
  if (!over) return false;
  ++state_.stage;
  state_.ends.push_back(simulation.time());
  state_.stage_start = simulation.time();
  state_.rest = {};
  set_motions(simulation);
  return true;
}

void Schedule::set_motions(engine::Simulation& simulation) const {
  for (std::size_t k = 0; k < tooling_.tools.size(); ++k) {
    const ToolPose before = pose_before(state_.stage, k);
    const bool on_the_move = !finished() && stages_[state_.stage]->tool() == tooling_.tools[k].spec.name;
    if (!on_the_move) {
      simulation.set_motion(k, [still = body_motion(before)](double) { return still; });
      continue;
    }
    simulation.set_motion(k, [step = stages_[state_.stage], before, start = state_.stage_start](double time) {
      const double since = std::clamp(time - start, 0.0, *step->duration());
      return body_motion(compose(step->motion(since), before));
    });
  }
}

ToolPose Schedule::pose_before(std::size_t stage, std::size_t k) const {
  ToolPose pose;
  for (std::size_t s = 0; s < std::min(stage, stages_.size()); ++s)
    if (stages_[s]->tool() == tooling_.tools[k].spec.name && stages_[s]->duration())
      pose = standing_still(compose(stages_[s]->motion(*stages_[s]->duration()), pose));
  return pose;
}

std::vector<results::Stage> Schedule::past() const {
  std::vector<results::Stage> stages;
  double start = 0;
  for (std::size_t s = 0; s < std::min(state_.ends.size(), stages_.size()); ++s) {
    stages.push_back({stages_[s]->tool(), stages_[s]->in_words(), start, state_.ends[s]});
    start = state_.ends[s];
  }
  return stages;
}

std::string Schedule::in_words() const {
  return finished() ? "done" : stages_[state_.stage]->in_words();
}

double Schedule::time_left(double now, double settling_time) const {
  double left = 0;
  for (std::size_t s = state_.stage; s < stages_.size(); ++s) {
    const double whole = stages_[s]->duration().value_or(settling_time);
    left += s == state_.stage ? std::max(0.0, whole - (now - state_.stage_start)) : whole;
  }
  return left;
}

geometry::Box Schedule::swept() const {
  geometry::Box box = tooling_.all;
  constexpr int kInstants = 200;
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    if (stages_[s]->tool().empty() || !stages_[s]->duration()) continue;
    const std::size_t k = tooling_.index_of(stages_[s]->tool());
    const ToolPose before = pose_before(s, k);
    for (int n = 0; n <= kInstants; ++n) {
      const ToolPose pose = compose(stages_[s]->motion(*stages_[s]->duration() * n / kInstants), before);
      box.include(
          geometry::transformed(tooling_.tools[k].mesh, pose.rotation, pose.translation).bounding_box());
    }
  }
  return box;
}

}  // namespace diefill::process
