// Shoes that nothing can run out of.
#include "process/setup/setup_findings.h"
#include "process/tooling/examination/shoe_floor.h"

namespace diefill::process {

std::vector<SetupFinding> shoe_floor_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  for (const Tool& tool : tooling.tools) {
    if (tool.spec.role != ToolRole::shoe) continue;
    if (auto floor = closed_floor(scene, tool))
      findings.push_back({closed_floor_text(tool, *floor), std::move(floor->places)});
  }
  return findings;
}

}  // namespace diefill::process
