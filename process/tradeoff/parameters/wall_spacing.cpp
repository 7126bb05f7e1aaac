#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {

Parameter wall_spacing_parameter() {
  return {.name = "wall_spacing",
          .label = "spacing of wall spheres over their radius",
          .sign = "wall spacing",
          .finer = Finer::smaller,
          .current = [](const Scene& scene) { return number_text(scene.walls.spacing); },
          .usual =
              [](const Scene&) {
                return std::vector<std::string>{"2.4", "1.6", "1.2"};
              },
          .changes = sets_key("walls.spacing")};
}

}  // namespace diefill::process
