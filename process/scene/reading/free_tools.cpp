#include "process/scene/reading/free_tools.h"

#include "process/machine/free_motion.h"

namespace diefill::process {

void refuse_free_tools_beside(const Scene& scene) {
  for (const auto& step : scene.steps) {
    if (free_motion_of(*step) == nullptr) continue;
    const EconomySpec& economy = scene.economy;
    const std::string key = economy.sleep          ? "economy.sleep"
                            : economy.carry_beyond ? "economy.carry_beyond"
                            : economy.mirror       ? "economy.mirror"
                            : scene.suction        ? "suction"
                                                   : "";
    if (key.empty()) continue;
    throw SceneError(step->plan.where + ": a free tool and " + key +
                     " do not go together: the program does not know in advance where the tool goes; remove "
                     "one of the two");
  }
}

}  // namespace diefill::process
