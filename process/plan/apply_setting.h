// A scene with the numbers of its setting, and the tools that were read to find them.
#pragma once

#include <optional>

#include "process/plan/setting.h"
#include "process/tooling/tooling.h"

namespace diefill::process::plan {

/// A scene with the numbers of its setting, and its tools where they had to be read for that.
struct SceneWithSetting {
  Scene scene;
  std::optional<Tooling> tooling;  ///< without wall spheres
};

/// As scene_with_setting(), with the tools that it read.
SceneWithSetting apply_setting(const Scene& scene, const std::optional<Setting>& wanted);

}  // namespace diefill::process::plan
