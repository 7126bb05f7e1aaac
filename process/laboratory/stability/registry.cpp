#include "process/laboratory/stability/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& stability_experiments() {
  static const std::vector<Experiment> all = {
      {"time_step", "how long may a step be until energy appears from nowhere?", find_time_step_limit},
      {"walls", "what speed pushes a grain through a wall of spheres, and how rough is it?", find_wall_limit},
      {"damping", "what does damping cost in step and rebound?", find_damping_limit},
      {"cohesion", "what step resolves cohesion near zero overlap?", find_cohesion_limit},
      {"rotation", "how far may a grain turn in a step?", find_rotation_limit},
      {"rolling", "when does rolling resistance chatter or fly apart?", find_rolling_limit},
      {"attraction", "what steps do Luding's spring and van der Waals cut-offs need?", find_attraction_limit},
      {"stiffness", "how soft may grains be?", find_stiffness_limit},
      {"step_effect", "what does a longer step change in a settled bed?", find_effect_of_step},
  };
  return all;
}

}  // namespace diefill::process::laboratory
