#include "process/plan/memory.h"

namespace diefill::process::plan {

double predicted_memory(double spheres, double wall_spheres) {
  // Bytes. Fitted to three runs of the narrow ring with 5,516 to 27,587 spheres and 58,533 to 128,387 wall
  // spheres, which took 564 to 631 MB at most, while pictures were drawn. Most of it is the program itself.
  constexpr double kProgram = 501.6e6, kSphere = 1263, kWallSphere = 956;
  return kProgram + kSphere * spheres + kWallSphere * wall_spheres;
}

}  // namespace diefill::process::plan
