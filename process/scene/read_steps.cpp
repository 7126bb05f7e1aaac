#include "process/machine/step_registry.h"
#include "process/scene/sections.h"

namespace diefill::process {

std::vector<std::shared_ptr<Step>> read_steps(TableReader& document, const std::vector<ToolSpec>& tools) {
  std::vector<std::shared_ptr<Step>> steps;
  for (TableReader& table : document.tables("step")) {
    const StepFactory make = table.required_choice("kind", step_kinds());
    steps.push_back(make(table, tools));
    table.finish();
  }
  return steps;
}

}  // namespace diefill::process
