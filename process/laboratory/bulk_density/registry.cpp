#include "process/laboratory/bulk_density/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& bulk_density_experiments() {
  static const std::vector<Experiment> all = {
      {"mono_disperse", "how does rolling resistance loosen a bed of sticky spheres?",
       measure_mono_disperse_beds},
      {"log_normal", "how do density and contacts follow the spread of sizes?", measure_log_normal_beds},
  };
  return all;
}

}  // namespace diefill::process::laboratory
