#include "process/plan/memory.h"

namespace diefill::process::plan {

double predicted_memory(double spheres, double wall_spheres) {
  // Bytes. Held against seven shipped scenes with 2,863 to 53,263 spheres and 6,488 to 219,043 wall spheres,
  // which took 442 to 591 MB at most, while pictures were drawn: within 8 %. Most of it is the program itself,
  // so that the share of a sphere is known badly.
  constexpr double kProgram = 445e6, kSphere = 700, kWallSphere = 550;
  return kProgram + kSphere * spheres + kWallSphere * wall_spheres;
}

}  // namespace diefill::process::plan
