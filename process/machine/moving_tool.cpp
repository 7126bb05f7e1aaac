#include "process/machine/moving_tool.h"

#include <algorithm>

namespace diefill::process {

std::string read_moving_tool(TableReader& table, const std::vector<ToolSpec>& tools,
                             const std::vector<ToolRole>& allowed) {
  const auto fits = [&allowed](const ToolSpec& candidate) {
    return std::find(allowed.begin(), allowed.end(), candidate.role) != allowed.end();
  };
  const auto example = std::find_if(tools.begin(), tools.end(), fits);
  table.require("tool", '"' + (example != tools.end() ? example->name : in_words(allowed.front())) + '"');
  Choices<const ToolSpec*> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, &tool);
  const ToolSpec& tool = *table.required_choice("tool", names);
  if (!fits(tool)) {
    std::string roles;
    for (const ToolRole role : allowed) roles += (roles.empty() ? "" : " or ") + in_words(role);
    table.reject("tool", "its role is " + in_words(tool.role) + ", and this kind of step moves a " + roles);
  }
  return tool.name;
}

}  // namespace diefill::process
