#include "process/machine/moving_tool.h"

#include <algorithm>

namespace diefill::process {

std::string read_moving_tool(TableReader& table, const std::vector<ToolSpec>& tools,
                             const std::vector<ToolRole>& allowed) {
  const auto fits = [&allowed](const ToolSpec& candidate) {
    return std::find(allowed.begin(), allowed.end(), candidate.role) != allowed.end();
  };
  const auto example = std::find_if(tools.begin(), tools.end(), fits);
  table.require("tool", '"' + (example != tools.end() ? example->name : description(allowed.front())) + '"');
  Choices<const ToolSpec*> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, &tool);
  const ToolSpec& tool = *table.required_choice("tool", names);
  if (!fits(tool)) {
    std::string roles;
    for (const ToolRole role : allowed) roles += (roles.empty() ? "" : " or ") + description(role);
    table.reject("tool",
                 "its role is " + description(tool.role) + ", but this kind of step moves a " + roles);
  }
  return tool.name;
}

std::vector<std::string> read_moving_tools(TableReader& table, const std::vector<ToolSpec>& tools) {
  Choices<const ToolSpec*> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, &tool);
  if (!table.has("tools")) return {table.required_choice("tool", names)->name};
  if (table.has("tool")) table.reject("tool", "tools is given as well; remove one of the two");
  const std::vector<std::string> wanted = table.texts("tools", tools.front().name);
  for (auto name = wanted.begin(); name != wanted.end(); ++name) {
    const bool known =
        std::any_of(tools.begin(), tools.end(), [&](const ToolSpec& tool) { return tool.name == *name; });
    if (known && std::find(wanted.begin(), name, *name) == name) continue;
    std::string all;
    for (const ToolSpec& tool : tools) all += (all.empty() ? "\"" : ", \"") + tool.name + '"';
    table.reject("tools", (known ? "\"" + *name + "\" is listed twice" : "there is no \"" + *name + '"') +
                              "; the tools of this scene are " + all);
  }
  return wanted;
}

}  // namespace diefill::process
