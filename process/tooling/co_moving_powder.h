// Powder that moves with the shoe as a block (economy.carry_beyond).
#pragma once

#include <optional>

#include "engine/simulation/sleeping.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Settings for powder carried in the shoe's frame, except near cavities; nothing where the scene does not
/// ask for it. Throws SceneError where there is no cavity to be far from, no shoe or several, or where the
/// die moves or the shoe turns.
std::optional<engine::SleepSettings> co_moving_powder(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
