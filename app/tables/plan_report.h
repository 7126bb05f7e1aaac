// What `plan` says: on the terminal and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "process/plan/plan.h"

namespace diefill::app {

/// Needs, then a table of the choices, then where the figures come from.
void print_plan(const process::plan::Plan& plan);

/// The scene's lines that take a choice's numbers, for copying into a scene file.
std::string scene_lines(const process::Scene& scene, const process::plan::SettingNumbers& numbers);

/// All that print_plan() says, in SI units.
nlohmann::ordered_json plan_as_json(const process::plan::Plan& plan);
nlohmann::ordered_json choice_as_json(const process::plan::Choice& choice);

}  // namespace diefill::app
