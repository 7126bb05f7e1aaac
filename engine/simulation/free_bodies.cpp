#include "engine/simulation/free_bodies.h"

#include <stdexcept>

#include "engine/simulation/simulation.h"

namespace diefill::engine {

namespace {

BodyLoad load_of(const Simulation& simulation, std::size_t body) {
  const WallLoad& load = simulation.wall_load(body);
  return {load.force, load.torque};
}

}  // namespace

const FreeBody* FreeBodies::of(std::size_t body) const {
  for (const FreeBody& free : bodies_)
    if (free.spec.body == body) return &free;
  return nullptr;
}

void FreeBodies::release(const FreeBodySpec& spec, Simulation& simulation) {
  if (simulation.settings().sleep)
    throw std::invalid_argument("sleeping grains cannot be combined with a free tool");
  if (spec.body >= simulation.bodies().size()) throw std::invalid_argument("there is no such body");
  if (of(spec.body) != nullptr) throw std::invalid_argument("the body is free already");
  bodies_.push_back(released(spec, simulation.body_motion(spec.body), load_of(simulation, spec.body)));
  poses_.push_back(std::make_shared<BodyMotion>(pose_of(bodies_.back())));
  apply_motions(simulation);
}

void FreeBodies::hold(std::size_t body, Simulation& simulation) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    FreeBody& free = bodies_[k];
    if (free.spec.body != body) continue;
    free.held = true;
    free.velocity.setZero();
    free.spin.setZero();
    *poses_[k] = pose_of(free);
  }
  apply_motions(simulation);
}

void FreeBodies::before_step(const Simulation& simulation) {
  const SimulationSettings& settings = simulation.settings();
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    *poses_[k] = advance(bodies_[k], settings.gravity, settings.time_step);
}

void FreeBodies::after_step(Simulation& simulation) {
  const SimulationSettings& settings = simulation.settings();
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    *poses_[k] = finish(bodies_[k], *poses_[k], load_of(simulation, bodies_[k].spec.body), settings.gravity,
                        settings.time_step);
  apply_motions(simulation);
}

void FreeBodies::apply_motions(Simulation& simulation) {
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    simulation.set_motion(bodies_[k].spec.body, [pose = poses_[k]](double) { return *pose; });
}

void FreeBodies::restore(const std::vector<FreeBody>& state, Simulation& simulation) {
  bodies_ = state;
  poses_.clear();
  for (const FreeBody& free : bodies_) poses_.push_back(std::make_shared<BodyMotion>(pose_of(free)));
  apply_motions(simulation);
}

}  // namespace diefill::engine
