#include "process/laboratory/walls/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& wall_experiments() {
  static const std::vector<Experiment> all = {
      {"rebound", "how do speed and direction of a rebound differ from those on the surface itself?",
       compare_rebound},
      {"sliding", "what friction does a grain feel that slides over wall spheres?", compare_sliding},
      {"bed", "what do wall spheres change in the powder that settles on them?", compare_beds},
  };
  return all;
}

}  // namespace diefill::process::laboratory
