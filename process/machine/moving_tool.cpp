#include "process/machine/moving_tool.h"

#include <algorithm>

namespace diefill::process {

std::string read_moving_tool(TableReader& table, const std::vector<ToolSpec>& tools,
                             const std::vector<ToolRole>& allowed) {
  Choices<const ToolSpec*> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, &tool);
  const ToolSpec& tool = *table.required_choice("tool", names);
  if (std::find(allowed.begin(), allowed.end(), tool.role) == allowed.end()) {
    std::string roles;
    for (const ToolRole role : allowed) roles += (roles.empty() ? "" : " or ") + in_words(role);
    table.reject("tool", "its role is " + in_words(tool.role) + ", and this kind of step moves a " + roles);
  }
  return tool.name;
}

}  // namespace diefill::process
