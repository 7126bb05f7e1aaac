// Why tools have no cavity: the most likely mistake, found by trying what would correct it.
#pragma once

#include <string>
#include <vector>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// The likeliest reason, with numbers and what to do: a tool in a wrong unit, a fill plane in other
/// coordinates, tools drawn with another axis up or upside down, a way out at the side, no punch, a punch
/// that is too low, too high, beside the hole or too narrow for it. `poses`: as the steps that make the
/// cavity leave the tools.
std::string why_no_cavity(const Scene& scene, const Tooling& tooling, const std::vector<ToolPose>& poses);

/// The tool that would fit the others in another unit of length, and what to write; empty for none.
/// Tools as they stand at the start; `tooling` knows its die.
std::string wrong_unit(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
