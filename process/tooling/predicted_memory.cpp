#include "process/tooling/predicted_memory.h"

namespace diefill::process::plan {

double predicted_memory(double spheres, double wall_spheres) {
  // Bytes. Compared with twelve shipped scenes with 2,863 to 220,675 spheres and 6,488 to 267,375 wall
  // spheres, which took 442 to 658 MB at most, while pictures were drawn: within 9 %. Most of it is the
  // program itself, so that the memory per sphere is poorly determined.
  constexpr double kProgram = 470e6, kSphere = 500, kWallSphere = 560;
  return kProgram + kSphere * spheres + kWallSphere * wall_spheres;
}

}  // namespace diefill::process::plan
