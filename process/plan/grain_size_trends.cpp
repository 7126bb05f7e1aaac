#include "process/plan/grain_size_trends.h"

namespace diefill::process::plan {

const std::vector<GrainSizeTrend>& grain_size_trends() {
  static const std::vector<GrainSizeTrend> all = {
      {"square", "Distaloy AE", "mass of a full cavity", -0.1649, 0.1582, 0.0479, 0.25, 0.48, 12},
      {"square", "Distaloy AE", "unevenness", -0.0445, 0.0341, 0.0033, 0.25, 0.33, 6},
      {"square", "ASC100.29 D2", "mass of a full cavity", -0.2206, 0.0998, 0.0302, 0.25, 0.48, 12},
      {"square", "ASC100.29 D2", "unevenness", -0.1488, 0.0289, 0.0028, 0.25, 0.33, 6},
      {"slot", "Distaloy AE", "mass of a full cavity", -0.2216, 0.0868, 0.0263, 0.25, 0.48, 12},
      {"slot", "Distaloy AE", "mean solid fraction", -0.0071, 0.0850, 0.0169, 0.25, 0.48, 4},
      {"slot", "Distaloy AE", "unevenness", -0.0390, 0.0259, 0.0078, 0.25, 0.48, 12},
      {"slot", "ASC100.29 D2", "mass of a full cavity", -0.3429, 0.1228, 0.0227, 0.33, 0.48, 9},
      {"slot", "ASC100.29 D2", "unevenness", 0.0067, 0.0455, 0.0084, 0.33, 0.48, 9},
      {"ring_6mm", "Distaloy AE", "mass of a full cavity", -0.0926, 0.0290, 0.0032, 0.33, 0.42, 6},
      {"ring_6mm", "Distaloy AE", "unevenness", 0.0004, 0.0500, 0.0055, 0.33, 0.42, 6},
      {"ring_6mm", "ASC100.29 D2", "mass of a full cavity", -0.1918, 0.0457, 0.0084, 0.33, 0.48, 9},
      {"ring_6mm", "ASC100.29 D2", "mean solid fraction", -0.1007, 0.0483, 0.0063, 0.33, 0.48, 4},
      {"ring_6mm", "ASC100.29 D2", "unevenness", -0.0007, 0.0234, 0.0043, 0.33, 0.48, 9},
      {"square (mesh)", "Distaloy AE", "mass of a full cavity", -0.2769, 0.0731, 0.0304, 0.125, 0.42, 15},
      {"square (mesh)", "Distaloy AE", "mean solid fraction", -0.0899, 0.1105, 0.0302, 0.125, 0.33, 12},
      {"square (mesh)", "Distaloy AE", "unevenness", -0.1062, 0.0179, 0.0049, 0.125, 0.33, 12},
      {"square (mesh)", "ASC100.29 D2", "mass of a full cavity", -0.1415, 0.1378, 0.0449, 0.1667, 0.42, 12},
      {"square (mesh)", "ASC100.29 D2", "mean solid fraction", -0.2306, 0.1181, 0.0236, 0.1667, 0.33, 9},
      {"square (mesh)", "ASC100.29 D2", "unevenness", -0.0784, 0.0517, 0.0103, 0.1667, 0.33, 9}};
  return all;
}

}  // namespace diefill::process::plan
