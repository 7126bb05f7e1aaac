#include "process/run/economies.h"

#include <algorithm>
#include <cstdio>

namespace diefill::process {

std::vector<std::string> economies_in_words(const Scene& scene, const engine::Simulation& simulation,
                                            std::uint64_t sphere_steps) {
  std::vector<std::string> lines;
  if (scene.economy.mirror)
    lines.push_back(
        std::string("half model: computed on one side of the plane ") +
        (*scene.economy.mirror == 0 ? "x" : "y") +
        " = 0 alone, and shown with its mirror image; differences between both halves are left out");
  if (scene.economy.sleep) {
    char text[160];
    const double share = static_cast<double>(simulation.sphere_steps_left_out()) /
                         static_cast<double>(std::max<std::uint64_t>(1, sphere_steps));
    std::snprintf(text, sizeof text,
                  "settled grains were put to sleep: %.1f %% of all sphere-steps were left out", 100 * share);
    lines.emplace_back(text);
  }
  return lines;
}

}  // namespace diefill::process
