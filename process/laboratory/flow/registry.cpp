#include "process/laboratory/flow/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& flow_experiments() {
  static const std::vector<Experiment> all = {
      {"hopper", "do kinematic models describe the flow out of a hopper, and does it scale with its slit?",
       compare_hopper, true},
      {"transient", "how does the flow out of a hopper grow once its slit opens?", measure_transient, true},
  };
  return all;
}

}  // namespace diefill::process::laboratory
