#include "process/plan/apply_setting.h"

#include <utility>

#include "process/setup/read_tooling.h"

namespace diefill::process::plan {

SceneWithSetting apply_setting(const Scene& scene, const std::optional<Setting>& wanted) {
  const auto setting = wanted ? wanted : setting_of(scene);
  if (!setting) return {scene, std::nullopt};
  if (const std::string why = why_no_settings(scene); !why.empty())
    throw SceneError(scene.file.string() + ": setting: found \"" + description(*setting) + "\", but " + why +
                     "; remove it");
  Tooling tooling = read_tooling(scene);
  Scene changed = with_numbers(scene, numbers_of(*setting, scene, tooling.all_cavities()),
                               "setting " + description(*setting));
  return {std::move(changed), std::move(tooling)};
}

Scene scene_with_setting(const Scene& scene, const std::optional<Setting>& wanted) {
  return apply_setting(scene, wanted).scene;
}

}  // namespace diefill::process::plan
