// Tool meshes cut open by a vertical plane, ready to be drawn: metal outside, a flat darker tone on the cut.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "process/results/fill_result.h"

namespace diefill::render {

/// VTK works in mm: its tolerances are made for lengths of order one.
inline constexpr double kMillimetres = 1e3;

/// The part of the tool at y >= cut_y (m), in mm, with the cut closed where the mesh is; nullptr where
/// nothing is left. Points have normals, cells their colour as three bytes.
vtkSmartPointer<vtkPolyData> cut_surface(const results::ToolState& tool, double cut_y);

/// The same, ready to be drawn.
vtkSmartPointer<vtkActor> make_cut_tool(const results::ToolState& tool, double cut_y);

}  // namespace diefill::render
