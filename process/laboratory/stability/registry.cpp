#include "process/laboratory/stability/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& stability_experiments() {
  static const std::vector<Experiment> all = {
      {"time_step", "how long may a step be until energy appears from nowhere?", find_time_step_limit},
      {"walls", "what speed pushes a grain through a wall of spheres, and how rough is it?", find_wall_limit},
  };
  return all;
}

}  // namespace diefill::process::laboratory
