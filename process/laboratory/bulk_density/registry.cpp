#include "process/laboratory/bulk_density/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& bulk_density_experiments() {
  static const std::vector<Experiment> all = {
      {"mono_disperse", "how does rolling resistance reduce the density of cohesive spheres?",
       measure_mono_disperse_beds},
      {"log_normal", "how do density and contacts depend on the width of the size distribution?",
       measure_log_normal_beds},
  };
  return all;
}

}  // namespace diefill::process::laboratory
