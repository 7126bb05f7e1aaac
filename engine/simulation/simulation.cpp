#include "engine/simulation/simulation.h"

#include "engine/powder/rigid_motion.h"
#include "engine/simulation/contact_search.h"
#include "engine/simulation/step_phases.h"

namespace diefill::engine {

Simulation::Simulation(const SimulationSettings& settings, std::vector<WallBodySpec> walls)
    : state_(settings, std::move(walls)), policy_(policy_for(state_.settings)) {
  sort_and_search(state_, *policy_);
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Eigen::Vector3d Simulation::angular_velocity(std::size_t k) const {
  return rotation_matrix(state_.grains.orientation_of(k)) * state_.grains.spin[k];
}

void Simulation::step() {
  SimulationState& now = state_;
  now.timers.begin();
  now.time = static_cast<double>(++now.step) * now.settings.time_step;
  policy_->move_tools(now);
  advance_grains(now, *policy_);
  now.timers.lap(Phase::advance);
  if (list_is_old(now)) {
    now.reference.skin = now.skin.next(now.reference.skin, now.step - now.reference.step);
    policy_->before_search(now);
    sort_and_search(now, *policy_);
    now.timers.lap(Phase::search);
  }
  policy_->compute_forces(now);
  add_up_blocks(now);
  policy_->end_step(now);
  now.timers.lap(Phase::gather);
}

}  // namespace diefill::engine
