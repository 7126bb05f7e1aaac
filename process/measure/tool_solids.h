// Tools as solids, for measures that must separate powder from tools.
#pragma once

#include <vector>

#include "geometry/solid/solid_query.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// The solids of all tools that have a surface, where they stand in the results.
inline std::vector<geometry::SolidQuery> solids_of(const std::vector<results::ToolState>& tools) {
  std::vector<geometry::SolidQuery> solids;
  for (const auto& tool : tools)
    if (!tool.triangles.empty()) solids.emplace_back(geometry::Mesh{tool.vertices, tool.triangles});
  return solids;
}

}  // namespace diefill::process
