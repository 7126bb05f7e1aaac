// The tool that a step of the scene moves.
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"
#include "process/scene/table_reader.h"

namespace diefill::process {

/// The name under `tool`, checked: it must be one of `tools` and have one of the `allowed` roles. Throws
/// SceneError.
std::string read_moving_tool(TableReader& table, const std::vector<ToolSpec>& tools,
                             const std::vector<ToolRole>& allowed);

}  // namespace diefill::process
