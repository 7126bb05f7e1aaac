#include "process/run/economies.h"

#include <algorithm>
#include <cstdio>

#include "engine/observe/powder_figures.h"
#include "process/input/units.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/walls_without_effect.h"

namespace diefill::process {

namespace {

std::string left_out(const engine::Simulation& simulation, std::uint64_t sphere_steps) {
  char text[80];
  const double share = static_cast<double>(engine::sphere_steps_left_out(simulation)) /
                       static_cast<double>(std::max<std::uint64_t>(1, sphere_steps));
  std::snprintf(text, sizeof text, "%.1f %% of all sphere-steps were skipped", 100 * share);
  return text;
}

}  // namespace

std::vector<std::string> economies_text(const Scene& scene, const engine::Simulation& simulation,
                                        std::uint64_t sphere_steps) {
  std::vector<std::string> lines;
  if (scene.economy.mirror) {
    const std::string axis = *scene.economy.mirror == 0 ? "x" : "y";
    lines.push_back("half model: only one side of the plane " + axis +
                    " = 0 was computed; the other half is its mirror image, so differences between the "
                    "halves are not captured");
  }
  if (scene.economy.sleep)
    lines.push_back("settled grains were frozen (economy.sleep): " + left_out(simulation, sphere_steps));
  if (scene.economy.carry_beyond)
    lines.push_back("powder in the shoe farther than " + number_text(1e3 * *scene.economy.carry_beyond) +
                    " mm from a cavity was moved as a rigid block: " + left_out(simulation, sphere_steps));
  if (const std::string limit = preset_warning(scene.powder); !limit.empty()) lines.push_back(limit);
  for (const std::string& line : walls_without_effect(scene)) lines.push_back(line);
  return lines;
}

}  // namespace diefill::process
