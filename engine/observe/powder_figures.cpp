#include "engine/observe/powder_figures.h"

#include "engine/simulation/simulation.h"

namespace diefill::engine {

std::size_t sphere_count(const Simulation& simulation) {
  const std::size_t grains = simulation.grains().size();
  if (simulation.types().equal_counts()) return grains * simulation.types().spheres();
  std::size_t count = 0;
  for (std::size_t k = 0; k < grains; ++k) count += simulation.shape_of(k).spheres();
  return count;
}

double powder_mass(const Simulation& simulation) {
  return simulation.state().mass_of(0, simulation.grains().size());
}

std::size_t sleepers(const Simulation& simulation) {
  return simulation.state().sleep.sleepers();
}

bool asleep(const Simulation& simulation, std::size_t k) {
  return simulation.state().sleep.sleeps(k);
}

std::uint64_t sphere_steps_left_out(const Simulation& simulation) {
  return simulation.state().sleep.sphere_steps_left_out;
}

}  // namespace diefill::engine
