#include "process/run/live_state.h"

#include "engine/simulation/powder_energy.h"
#include "process/run/assemble.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

LiveState live_state(const Tooling& tooling, const FillRun& run) {
  const engine::Simulation& simulation = run.simulation();
  LiveState state;
  state.time = simulation.time();
  state.share = run.share_done();
  state.filled_mass = process::filled_mass(simulation, tooling);
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
