#include "process/plan/memory.h"

namespace diefill::process::plan {

double predicted_memory(double spheres, double wall_spheres) {
  constexpr double kProgram = 1e8, kSphere = 392, kWallSphere = 1000;
  return kProgram + kSphere * spheres + kWallSphere * wall_spheres;
}

}  // namespace diefill::process::plan
