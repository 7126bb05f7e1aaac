// Triangles as VTK's types.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <vector>

namespace diefill::render {

/// A mesh whose vertices (m) become points in mm.
vtkSmartPointer<vtkPolyData> mesh_polydata(const std::vector<Eigen::Vector3d>& vertices,
                                           const std::vector<Eigen::Vector3i>& triangles);

}  // namespace diefill::render
