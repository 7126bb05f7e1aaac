#include "process/plan/grain_size_trends.h"

namespace diefill::process::plan {

const std::vector<GrainSizeTrend>& grain_size_trends() {
  static const std::vector<GrainSizeTrend> all = {
      {"square", "Distaloy AE", "mass of a full cavity", 0.2798, 0.1592, 0.0332, 0.25, 0.42, 9},
      {"square", "Distaloy AE", "unevenness", -0.0507, 0.0389, 0.0038, 0.25, 0.33, 6},
      {"square", "ASC100.29 D2", "mass of a full cavity", -0.0067, 0.0697, 0.0145, 0.25, 0.42, 9},
      {"square", "ASC100.29 D2", "unevenness", -0.1590, 0.0309, 0.0030, 0.25, 0.33, 6},
      {"slot", "Distaloy AE", "mass of a full cavity", 0.0506, 0.0601, 0.0113, 0.25, 0.42, 8},
      {"slot", "Distaloy AE", "unevenness", -0.0881, 0.0378, 0.0071, 0.25, 0.42, 8},
      {"slot", "ASC100.29 D2", "mass of a full cavity", -0.0134, 0.1685, 0.0186, 0.33, 0.42, 6},
      {"slot", "ASC100.29 D2", "unevenness", 0.0004, 0.1081, 0.0119, 0.33, 0.42, 6},
      {"ring_6mm", "Distaloy AE", "mass of a full cavity", -0.0926, 0.0290, 0.0032, 0.33, 0.42, 6},
      {"ring_6mm", "Distaloy AE", "unevenness", 0.0004, 0.0500, 0.0055, 0.33, 0.42, 6},
      {"ring_6mm", "ASC100.29 D2", "mass of a full cavity", -0.2273, 0.0744, 0.0073, 0.33, 0.42, 5},
      {"ring_6mm", "ASC100.29 D2", "unevenness", 0.0033, 0.0622, 0.0061, 0.33, 0.42, 5}};
  return all;
}

}  // namespace diefill::process::plan
