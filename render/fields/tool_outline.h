// Where a plane cuts the tools: the outlines that a section shows.
#pragma once

#include "process/results/fill_result.h"
#include "render/fields/field_style.h"

namespace diefill::render {

/// Lines in which the tools' meshes meet the plane, in mm along its axes from its origin. All lines
/// go round their solid the same way.
std::vector<Outline> tool_outlines(const std::vector<results::ToolState>& tools,
                                   const results::SectionPlane& plane);

}  // namespace diefill::render
