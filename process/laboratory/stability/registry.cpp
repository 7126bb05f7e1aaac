#include "process/laboratory/stability/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& stability_experiments() {
  static const std::vector<Experiment> all = {
      {"time_step", "how long may a step be until energy appears from nowhere?", find_time_step_limit},
      {"walls", "what speed pushes a grain through a wall of spheres, and how rough is it?", find_wall_limit},
      {"wall_friction", "what friction does a wall of spheres have in effect?", find_wall_friction_limit},
      {"damping", "what does damping cost in step and rebound?", find_damping_limit},
      {"cohesion", "what step resolves cohesion near zero overlap?", find_cohesion_limit},
      {"rotation", "how far may a grain turn in a step?", find_rotation_limit},
      {"rolling", "when does rolling resistance chatter or fly apart?", find_rolling_limit},
      {"creep", "which heaps of rolling spheres keep creeping?", find_creep_limit},
      {"attraction", "what steps do Luding's spring and van der Waals cut-offs need?", find_attraction_limit},
      {"capillary", "what does the smallest gap of a liquid bridge change?", find_capillary_limit},
      {"size_ratio", "is friction right between fine and large grains?", find_size_ratio_limit},
      {"piston", "at which gain does a force-controlled piston ring?", find_piston_limit},
      {"cavity", "how coarse may grains be for a narrow cavity?", find_cavity_limit},
      {"stiffness", "how soft may grains be?", find_stiffness_limit},
      {"step_effect", "what does a longer step change in a settled bed?", find_effect_of_step},
      {"step_flow", "what does a longer step change in discharge and heaps?", find_effect_of_step_on_flow},
  };
  return all;
}

}  // namespace diefill::process::laboratory
