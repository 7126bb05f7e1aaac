#include "render/scene3d/paraview_files.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <QString>
#include <array>
#include <sstream>
#include <stdexcept>

#include "process/results/storage/atomic_file.h"

namespace diefill::render {
namespace {

vtkSmartPointer<vtkDoubleArray> vtk_array(const PointArray& array, std::size_t points) {
  if (array.components < 1 || array.values.size() != points * static_cast<std::size_t>(array.components))
    throw std::invalid_argument("array \"" + array.name + "\" has " + std::to_string(array.values.size()) +
                                " values for " + std::to_string(points) + " points");
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName(array.name.c_str());
  values->SetNumberOfComponents(array.components);
  values->SetNumberOfTuples(static_cast<vtkIdType>(points));
  std::copy(array.values.begin(), array.values.end(), values->GetPointer(0));
  return values;
}

template <class Writer>
void write(const std::filesystem::path& file, vtkDataObject* data) {
  const auto writer = vtkSmartPointer<Writer>::New();
  writer->SetInputDataObject(data);
  // Appended data, the default, are not read by VTK 9.1 and ParaView 5.11 with the expat of Debian 12's
  // updates.
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  results::write_text_atomically(file, writer->GetOutputString());
}

}  // namespace

void write_points(const std::filesystem::path& file, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<PointArray>& arrays) {
  const auto places = vtkSmartPointer<vtkPoints>::New();
  places->SetDataTypeToDouble();
  const auto vertices = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& point : points) {
    const vtkIdType number = places->InsertNextPoint(point.data());
    vertices->InsertNextCell(1, &number);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetVerts(vertices);
  for (const auto& array : arrays) data->GetPointData()->AddArray(vtk_array(array, points.size()));
  write<vtkXMLPolyDataWriter>(file, data);
}

void write_grid(const std::filesystem::path& file, const PointGrid& grid,
                const std::vector<PointArray>& arrays) {
  const auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetOrigin(grid.origin.x(), grid.origin.y(), grid.origin.z());
  data->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  data->SetDimensions(grid.counts.x(), grid.counts.y(), grid.counts.z());
  for (const auto& array : arrays) data->GetPointData()->AddArray(vtk_array(array, grid.size()));
  write<vtkXMLImageDataWriter>(file, data);
}

void write_cells(const std::filesystem::path& file, const PointGrid& grid,
                 const std::vector<PointArray>& arrays) {
  const auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetOrigin(grid.origin.x(), grid.origin.y(), grid.origin.z());
  data->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  data->SetDimensions(grid.counts.x() + 1, grid.counts.y() + 1, grid.counts.z() + 1);
  for (const auto& array : arrays) data->GetCellData()->AddArray(vtk_array(array, grid.size()));
  write<vtkXMLImageDataWriter>(file, data);
}

void write_tools(const std::filesystem::path& file, const std::vector<results::ToolState>& tools,
                 int counted_from) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto faces = vtkSmartPointer<vtkCellArray>::New();
  const auto number = vtkSmartPointer<vtkIntArray>::New();
  number->SetName("tool");
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const auto& vertex : tools[t].vertices) points->InsertNextPoint(vertex.data());
    for (const auto& triangle : tools[t].triangles) {
      const std::array<vtkIdType, 3> corners{first + triangle[0], first + triangle[1], first + triangle[2]};
      faces->InsertNextCell(3, corners.data());
      number->InsertNextValue(counted_from + static_cast<int>(t));
    }
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(faces);
  data->GetCellData()->AddArray(number);
  write<vtkXMLPolyDataWriter>(file, data);
}

void write_series(const std::filesystem::path& file, const std::vector<SeriesFile>& files) {
  const auto quoted = [](const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped().toStdString();
  };
  std::ostringstream text;
  text.precision(17);
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (const auto& [time, part, name, path] : files)
    text << "    <DataSet timestep=\"" << time << "\" group=\"\" part=\"" << part << "\" name=\""
         << quoted(name) << "\" file=\"" << quoted(path) << "\"/>\n";
  text << "  </Collection>\n</VTKFile>\n";
  results::write_text_atomically(file, text.str());
}

}  // namespace diefill::render
