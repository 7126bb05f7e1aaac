#include "process/plan/grain_size_trends.h"

namespace diefill::process::plan {

const std::vector<GrainSizeTrend>& open_scene_trends() {
  static const std::vector<GrainSizeTrend> all = {
      {"slit_discharge", "ASC100.29 D2", "mass through the opening", -0.5140, 0.4589, 0.0528, 0.141, 0.235,
       9},
      {"compressed_bed", "ASC100.29 D2", "bulk solid fraction", 0.1314, 0.2343, 0.0152, 0.0881, 0.1469, 8},
  };
  return all;
}

}  // namespace diefill::process::plan
