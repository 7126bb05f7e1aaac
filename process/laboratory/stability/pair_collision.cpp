#include "process/laboratory/stability/pair_collision.h"

#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

PairCollision meet_head_on(const engine::SimulationSettings& settings, double speed, double phase, long steps,
                           double range) {
  engine::Simulation simulation(settings, {});
  const double half = settings.shape().bounding_radius();
  engine::NewGrain left, right;
  right.position.x() = half + 0.5 * range + 0.5 * phase * speed * settings.time_step;
  left.position = -right.position;
  left.velocity.x() = 0.5 * speed;
  right.velocity = -left.velocity;
  simulation.add_grains({left, right});
  const auto along = [&](const std::vector<Eigen::Vector3d>& of) {
    const bool in_order = simulation.grains().id[0] == 0;
    return (of[in_order ? 1 : 0] - of[in_order ? 0 : 1]).x();
  };
  PairCollision end;
  for (long k = 0; k < steps && !end.parted; ++k) {
    simulation.step();
    const double closing = along(simulation.grains().velocity);
    end.parted = along(simulation.grains().position) > 2 * half + range && closing > 0;
    end.rebound = end.parted ? closing : 0;
  }
  const auto energy = engine::energy_of(simulation);
  end.energy = energy.kinetic() + energy.contacts;
  end.deepest = simulation.deepest_overlap_of_run();
  end.time = simulation.time();
  return end;
}

}  // namespace diefill::process::laboratory
