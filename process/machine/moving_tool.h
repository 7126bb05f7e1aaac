// The tools that a step of the scene moves.
#pragma once

#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// The name under `tool`, checked: it must be one of `tools` and have one of the `allowed` roles. Throws
/// SceneError.
std::string read_moving_tool(TableReader& table, const std::vector<ToolSpec>& tools,
                             const std::vector<ToolRole>& allowed);

/// The names under `tools` (a list) or `tool` (one), checked: each must be one of `tools`, none twice. Throws
/// SceneError.
std::vector<std::string> read_moving_tools(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
