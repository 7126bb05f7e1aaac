#include "render/scene3d/mesh_polydata.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <array>

#include "render/scene3d/cut_tools.h"

namespace diefill::render {

vtkSmartPointer<vtkPolyData> mesh_polydata(const std::vector<Eigen::Vector3d>& vertices,
                                           const std::vector<Eigen::Vector3i>& triangles) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const auto& vertex : vertices)
    points->InsertNextPoint(kMillimetres * vertex.x(), kMillimetres * vertex.y(), kMillimetres * vertex.z());
  const auto faces = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& triangle : triangles) {
    const std::array<vtkIdType, 3> corners{triangle[0], triangle[1], triangle[2]};
    faces->InsertNextCell(3, corners.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

}  // namespace diefill::render
