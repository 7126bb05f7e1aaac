#include "process/run/live_state.h"

#include <algorithm>

#include "engine/simulation/powder_energy.h"
#include "process/measure/cavity_position.h"
#include "process/run/assemble.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

namespace diefill::process {
namespace {

/// kg in all cavities, as they are at rest.
double mass_in_cavities(const Tooling& tooling, const engine::Simulation& simulation) {
  std::vector<results::CavityState> cavities;
  if (tooling.cavity.found) cavities.push_back(cavity_state(tooling.cavity));
  for (const auto& other : tooling.other_cavities) cavities.push_back(cavity_state(other));
  const DieFrame die(simulation.body_motion(tooling.die));
  const engine::Grains& grains = simulation.grains();
  double mass = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const Eigen::Vector3d place = die.point(grains.position[k]);
    if (std::any_of(cavities.begin(), cavities.end(),
                    [&](const auto& cavity) { return lies_in_cavity(cavity, place); }))
      mass += simulation.shape_of(k).mass;
  }
  return copies(tooling) * mass;
}

}  // namespace

LiveState live_state(const Tooling& tooling, const FillRun& run) {
  const engine::Simulation& simulation = run.simulation();
  LiveState state;
  state.time = simulation.time();
  state.share = run.share_done();
  state.filled_mass = mass_in_cavities(tooling, simulation);
  state.kinetic_energy = copies(tooling) * engine::energy_of(simulation.state()).kinetic();
  state.sphere_steps_per_second = static_cast<double>(run.sphere_steps()) / run.wall_seconds();
  state.grains = simulation.grains().size();
  state.stage = run.schedule().description();
  results::FillResult margins;
  add_margin_figures(margins, run);
  state.margins = results::margins(margins);
  return state;
}

}  // namespace diefill::process
