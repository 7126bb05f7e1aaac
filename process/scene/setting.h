// `setting` of a scene: how fine to compute, for a scene that leaves grain size, time step, wall spheres and
// fill height to the planner (process/plan), and how the chosen values are written into its text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

enum class Setting { quick, working, reference };

/// The setting as a scene spells it, such as "working".
std::string description(Setting setting);
/// All names of settings, the coarsest first.
std::vector<std::string> setting_names();
/// The setting of that name. Throws SceneError, naming the nearest, for any other.
Setting setting_named(const std::string& name);

/// `setting` of a scene. Throws SceneError where the scene also gives a quantity that the setting chooses.
std::optional<Setting> read_setting(TableReader& document);
/// [pour] of a scene with a setting, which has no fill height: until the setting is turned into numbers it is
/// the whole height of the box.
PourSpec read_pour_without_height(TableReader table, const Scene& scene);

/// The setting that the scene's text names. It is to be turned into numbers before anything runs.
std::optional<Setting> setting_of(const Scene& scene);

/// Comment lines at the top of a scene whose numbers were chosen: the source of the choice, then what.
std::string as_comment(const std::vector<std::string>& chosen);
/// The same read from a scene's text; empty where nothing was chosen.
std::vector<std::string> chosen_numbers_in(const std::string& text);

}  // namespace diefill::process
