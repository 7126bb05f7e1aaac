#include "process/laboratory/flow/registry.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& flow_experiments() {
  static const std::vector<Experiment> all = {
      {"hopper",
       "do kinematic models describe the flow out of a hopper, and does it scale with its slit?",
       compare_hopper,
       {"D01", "D02", "D03", "D04", "D05", "D06", "D07", "D08", "D09", "D10", "D11", "D12", "D13", "D14",
        "D15"}},
      {"transient",
       "how does the flow out of a hopper grow once its slit opens?",
       measure_transient,
       {"E01", "E02", "E03", "E04", "E05"}},
  };
  return all;
}

}  // namespace diefill::process::laboratory
