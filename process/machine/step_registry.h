// The kinds of step a scene may use. To add one: a file of its own, and its line in step_registry.cpp.
#pragma once

#include <memory>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// Makes a step from its [[step]] table; `tools` are those of the scene, from which the step selects its own.
/// The caller rejects keys that the factory did not request. Throws SceneError.
using StepFactory = std::shared_ptr<Step> (*)(TableReader& table, const std::vector<ToolSpec>& tools);

/// Kinds by the value of `kind`, in the order in which messages list them.
const Choices<StepFactory>& step_kinds();

}  // namespace diefill::process
