#include "process/tooling/die_frame.h"

#include "engine/simulation/simulation.h"
#include "process/measure/cavity_position.h"
#include "process/tooling/grain_tally.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

results::CavityState cavity_state(const geometry::Cavity& found) {
  results::CavityState cavity;
  cavity.is_ring = found.is_ring;
  cavity.axis_origin = found.axis_origin;
  cavity.inner_radius = found.inner_radius;
  cavity.outer_radius = found.outer_radius;
  if (found.found) {
    cavity.lower_corner = found.box.lower;
    cavity.upper_corner = found.box.upper;
  }
  cavity.volume = found.volume;
  cavity.narrowest_width = found.narrowest_width;
  return cavity;
}

std::vector<results::CavityState> cavity_states(const Tooling& tooling) {
  std::vector<results::CavityState> all;
  if (tooling.cavity.found) all.push_back(cavity_state(tooling.cavity));
  for (const auto& other : tooling.other_cavities) all.push_back(cavity_state(other));
  return all;
}

engine::BodyMotion DieFrame::pose(const engine::BodyMotion& body) const {
  if (at_initial_pose()) return body;
  engine::BodyMotion posed;
  posed.rotation = rotation().transpose() * body.rotation;
  posed.translation = point(body.translation);
  return posed;
}

DieFrame die_frame(const engine::Simulation& simulation, const Tooling& tooling) {
  return DieFrame(tooling.has_die() ? simulation.body_motion(tooling.die) : engine::BodyMotion());
}

double filled_mass(const engine::Simulation& simulation, const Tooling& tooling) {
  const auto cavities = cavity_states(tooling);
  const DieFrame frame = die_frame(simulation, tooling);
  GrainTally filled;
  const engine::Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (lies_in_any_cavity(cavities, frame.point(grains.position[k]))) filled.add(grains.type_of(k));
  return copies(tooling) * filled.mass(simulation.types());
}

}  // namespace diefill::process
