#include "process/laboratory/stability/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& stability_experiments() {
  static const std::vector<Experiment> all = {
      {"time_step", "how long may a time step be without spurious energy gain?", find_time_step_limit},
      {"walls", "which speed pushes a grain through a wall of spheres, and how rough is the wall?",
       find_wall_limit},
      {"wall_friction", "what is the effective friction of a wall of spheres?", find_wall_friction_limit},
      {"damping", "how does damping affect time step and rebound?", find_damping_limit},
      {"cohesion", "which time step resolves cohesion near zero overlap?", find_cohesion_limit},
      {"rotation", "how far may a grain rotate in one time step?", find_rotation_limit},
      {"rolling", "when does rolling resistance chatter or become unstable?", find_rolling_limit},
      {"creep", "which heaps of rolling spheres creep?", find_creep_limit},
      {"attraction", "which time steps do Luding's spring and van der Waals cut-offs need?",
       find_attraction_limit},
      {"capillary", "what is the effect of the smallest gap of a liquid bridge?", find_capillary_limit},
      {"size_ratio", "is friction correct between fine and large grains?", find_size_ratio_limit},
      {"piston", "at which gain does a force-controlled piston oscillate?", find_piston_limit},
      {"fluid", "which time steps, densities and shear rates keep the temperature of a DPD fluid?",
       find_fluid_limit},
      {"cavity", "how coarse may grains be for a narrow cavity?", find_cavity_limit, {"M03"}},
      {"stiffness", "how soft may grains be?", find_stiffness_limit},
      {"step_effect", "what is the effect of a longer time step on a settled bed?", find_effect_of_step},
      {"step_flow", "what is the effect of a longer time step on discharge and heaps?",
       find_effect_of_step_on_flow},
  };
  return all;
}

}  // namespace diefill::process::laboratory
