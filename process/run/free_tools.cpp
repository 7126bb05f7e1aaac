#include "process/run/free_tools.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/simulation.h"
#include "process/machine/free_motion.h"
#include "process/tooling/free_tool.h"

namespace diefill::process {

FreeTools::FreeTools(const Scene& scene, const Tooling& tooling) : scene_(scene), tooling_(tooling) {
  for (std::size_t k = 0; k < scene.steps.size(); ++k)
    if (free_motion_of(*scene.steps[k]) != nullptr)
      recorded_.push_back({k, tooling.index_of(scene.steps[k]->tools().front()), {}});
}

void FreeTools::after_step(engine::Simulation& simulation) {
  if (!bodies_.any()) return;
  bodies_.after_step(simulation);
  for (RecordedMotion& motion : recorded_) {
    const engine::FreeBody* body = bodies_.of(motion.body);
    const double interval = free_motion_of(*scene_.steps[motion.step])->record;
    const auto every =
        static_cast<std::uint64_t>(std::max(1LL, std::llround(interval / simulation.settings().time_step)));
    if (body == nullptr || simulation.steps() % every != 0) continue;
    const Eigen::Vector3d spin = engine::rotation_matrix(body->orientation) * body->spin;
    motion.rows.push_back(simulation.time());
    for (const Eigen::Vector3d& vector : {body->position, body->velocity, spin})
      motion.rows.insert(motion.rows.end(), vector.data(), vector.data() + 3);
  }
}

void FreeTools::follow(const Schedule& schedule, engine::Simulation& simulation) {
  if (recorded_.empty()) return;
  bodies_.apply_motions(simulation);
  for (const RecordedMotion& motion : recorded_) {
    const StepState& state = schedule.of_step(motion.step);
    if (state.started == simulation.time())
      bodies_.release(free_body_of(tooling_, *scene_.steps[motion.step]), simulation);
    if (state.ended == simulation.time()) bodies_.hold(motion.body, simulation);
  }
}

FreeToolsState FreeTools::state() const {
  FreeToolsState kept{bodies_.state(), {}, {}};
  for (const RecordedMotion& motion : recorded_) {
    kept.numbers.push_back(motion.rows.size());
    kept.rows.insert(kept.rows.end(), motion.rows.begin(), motion.rows.end());
  }
  return kept;
}

void FreeTools::restore(const FreeToolsState& state, engine::Simulation& simulation) {
  // A start that runs share was kept before any tool was free, perhaps with fewer steps.
  if (!state.bodies.empty() && state.numbers.size() != recorded_.size())
    throw std::invalid_argument("the checkpoint has a different number of free tools");
  bodies_.restore(state.bodies, simulation);
  auto from = state.rows.begin();
  for (std::size_t k = 0; k < std::min(recorded_.size(), state.numbers.size()); ++k) {
    const auto to = from + static_cast<std::ptrdiff_t>(state.numbers[k]);
    recorded_[k].rows.assign(from, to);
    from = to;
  }
}

std::vector<results::ProbeSeries> FreeTools::recorded_motions() const {
  std::vector<results::ProbeSeries> all;
  for (const RecordedMotion& motion : recorded_) {
    results::ProbeSeries series;
    series.name = "motion of " + tooling_.tools[motion.body].spec.name;
    series.columns = {"time",       "x",          "y",      "z",      "velocity x",
                      "velocity y", "velocity z", "spin x", "spin y", "spin z"};
    series.units = {"s", "m", "m", "m", "m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"};
    series.values = motion.rows;
    all.push_back(std::move(series));
  }
  return all;
}

}  // namespace diefill::process
