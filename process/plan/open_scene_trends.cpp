#include "process/plan/grain_size_trends.h"

namespace diefill::process::plan {

const std::vector<GrainSizeTrend>& open_scene_trends() {
  static const std::vector<GrainSizeTrend> all = {};
  return all;
}

}  // namespace diefill::process::plan
