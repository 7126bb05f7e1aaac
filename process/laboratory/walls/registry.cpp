#include "process/laboratory/walls/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& wall_experiments() {
  static const std::vector<Experiment> all = {
      {"rebound", "how do speed and direction of a rebound differ from those on the exact surface?",
       compare_rebound},
      {"sliding", "what is the friction of a grain sliding over wall spheres?", compare_sliding},
      {"bed", "how do wall spheres affect powder that settles on them?", compare_beds},
  };
  return all;
}

}  // namespace diefill::process::laboratory
