#include "process/plan/memory.h"

namespace diefill::process::plan {

double predicted_memory(double spheres, double wall_spheres, bool several_sizes) {
  // Bytes. Held against ten shipped scenes with 2,863 to 220,675 spheres and 6,488 to 267,375 wall spheres,
  // which took 442 to 658 MB at most, while pictures were drawn: within 9 %. Most of it is the program
  // itself, so that the share of a sphere is known badly. What several sizes take was seen in one of them.
  constexpr double kProgram = 455e6, kSphere = 700, kWallSphere = 550, kSizes = 60e6;
  return kProgram + kSphere * spheres + kWallSphere * wall_spheres + (several_sizes ? kSizes : 0);
}

}  // namespace diefill::process::plan
