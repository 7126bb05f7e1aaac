#include "render/scene3d/solid_mesh_vtu.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringOutputWindow.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLFileReadTester.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

#include "process/results/storage/atomic_file.h"

namespace diefill::render {
namespace {

using results::SolidMesh;

/// The reader's first complaint, which VTK would print.
void note_error(vtkObject*, unsigned long, void* client, void* message) {
  auto& first = *static_cast<std::string*>(client);
  if (first.empty() && message != nullptr) first = static_cast<const char*>(message);
}

/// While it lives, what VTK would print and log goes nowhere: one line of our own says what is wrong.
class SilentVtk {
 public:
  SilentVtk() : before_(vtkOutputWindow::GetInstance()) {
    vtkOutputWindow::SetInstance(vtkSmartPointer<vtkStringOutputWindow>::New());
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~SilentVtk() {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);  // as it is at the start of a program
    vtkOutputWindow::SetInstance(before_);
  }
  SilentVtk(const SilentVtk&) = delete;
  SilentVtk& operator=(const SilentVtk&) = delete;

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
};

/// Throws std::invalid_argument where the file declares more points or cells than it can hold, for which VTK
/// would ask for the memory.
void refuse_excessive_counts(const std::filesystem::path& file) {
  constexpr std::size_t kHead = 65536;  // bytes; the counts stand before the data
  constexpr double kMaxPerByte = 100;   // deflate makes a thousand bytes one at best, a point has twelve
  std::string head(kHead, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(kHead));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  const auto bytes = static_cast<double>(std::filesystem::file_size(file));
  for (const std::string what : {"Points", "Cells"}) {
    const std::string key = "NumberOf" + what + "=\"";
    const std::size_t place = head.find(key);
    if (place == std::string::npos) continue;
    const double count = std::strtod(head.c_str() + place + key.size(), nullptr);
    if (count > kMaxPerByte * bytes)
      throw std::invalid_argument("declares " +
                                  head.substr(place, head.find('"', place + key.size()) - place + 1) +
                                  ", more than its " + std::to_string(static_cast<long long>(bytes)) +
                                  " bytes can hold; it may be cut short or damaged: write it again");
  }
}

vtkSmartPointer<vtkUnstructuredGrid> grid_in(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw std::invalid_argument("found no such file");
  const SilentVtk silent;
  const auto tester = vtkSmartPointer<vtkXMLFileReadTester>::New();
  tester->SetFileName(file.c_str());
  const bool is_vtk = tester->TestReadFile() != 0 && tester->GetFileDataType() != nullptr;
  const std::string kind = is_vtk ? tester->GetFileDataType() : "";
  if (kind != "UnstructuredGrid")
    throw std::invalid_argument(
        "found " + (kind.empty() ? "a file that is not in VTK format" : "VTK data of type " + kind) +
        ", expected an UnstructuredGrid (.vtu)");
  refuse_excessive_counts(file);
  std::string complaint;
  const auto listener = vtkSmartPointer<vtkCallbackCommand>::New();
  listener->SetCallback(note_error);
  listener->SetClientData(&complaint);
  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->SetReaderErrorObserver(listener);
  reader->SetParserErrorObserver(listener);
  reader->SetFileName(file.c_str());
  try {
    reader->Update();
  } catch (const std::bad_alloc&) {
    throw std::invalid_argument(
        "declares more data than there is memory for; it may be damaged: write it again");
  }
  if (!complaint.empty() || reader->GetErrorCode() != 0)
    throw std::invalid_argument("VTK cannot read it; it may be cut short or damaged: write it again");
  return reader->GetOutput();
}

std::optional<results::ElementShape> shape_of(int cell_type) {
  for (const auto& kind : results::element_kinds())
    if (kind.vtk == cell_type) return kind.shape;
  return {};
}

bool has_volume(int type) {
  constexpr int kPlane[] = {VTK_EMPTY_CELL,     VTK_VERTEX,          VTK_POLY_VERTEX,
                            VTK_LINE,           VTK_POLY_LINE,       VTK_TRIANGLE,
                            VTK_TRIANGLE_STRIP, VTK_POLYGON,         VTK_PIXEL,
                            VTK_QUAD,           VTK_QUADRATIC_EDGE,  VTK_QUADRATIC_TRIANGLE,
                            VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD};
  for (const int plane : kPlane)
    if (plane == type) return false;
  return true;
}

std::uint64_t number_of(vtkDataArray* ids, vtkIdType place) {
  return static_cast<std::uint64_t>(ids != nullptr ? ids->GetTuple1(place) : static_cast<double>(place));
}

void add_cell(SolidMesh& mesh, vtkUnstructuredGrid* grid, vtkIdType cell) {
  const int type = grid->GetCellType(cell);
  const auto shape = shape_of(type);
  if (!shape) {
    if (has_volume(type))
      throw std::invalid_argument(
          "cell " + std::to_string(cell) + " has VTK type " + std::to_string(type) +
          ", allowed: tetrahedra, hexahedra, wedges and pyramids (10, 12, 13, 14, 24, "
          "25, 26)");
    ++mesh.left_out;
    return;
  }
  const auto nodes = vtkSmartPointer<vtkIdList>::New();
  grid->GetCellPoints(cell, nodes);
  const vtkIdType count = nodes->GetNumberOfIds();
  results::SolidElement element{*shape, number_of(grid->GetCellData()->GetGlobalIds(), cell), {}};
  if (count != results::kind_of(*shape).nodes)
    throw std::invalid_argument("cell " + std::to_string(cell) + " has " + std::to_string(count) +
                                " points, expected " + std::to_string(results::kind_of(*shape).nodes));
  for (vtkIdType n = 0; n < count; ++n) {
    const vtkIdType node = nodes->GetId(n);
    if (node < 0 || node >= grid->GetNumberOfPoints())
      throw std::invalid_argument("cell " + std::to_string(cell) + " has point " + std::to_string(node) +
                                  ", which the file does not define");
    element.nodes[static_cast<std::size_t>(n)] = static_cast<std::uint32_t>(node);
  }
  mesh.elements.push_back(element);
}

template <class Data>
void add_arrays(Data* data, const std::vector<PointArray>& arrays, std::size_t count) {
  for (const auto& array : arrays) {
    if (array.values.size() != count * static_cast<std::size_t>(array.components))
      throw std::invalid_argument("array \"" + array.name + "\" does not fit the mesh");
    const auto values = vtkSmartPointer<vtkDoubleArray>::New();
    values->SetName(array.name.c_str());
    values->SetNumberOfComponents(array.components);
    values->SetNumberOfTuples(static_cast<vtkIdType>(count));
    std::copy(array.values.begin(), array.values.end(), values->GetPointer(0));
    data->AddArray(values);
  }
}

vtkSmartPointer<vtkIdTypeArray> numbers_array() {
  auto numbers = vtkSmartPointer<vtkIdTypeArray>::New();
  numbers->SetName("number");
  return numbers;
}

}  // namespace

SolidMesh read_vtu(const std::filesystem::path& file, double unit) {
  const auto grid = grid_in(file);
  SolidMesh mesh;
  vtkDataArray* ids = grid->GetPointData()->GetGlobalIds();
  for (vtkIdType n = 0; n < grid->GetNumberOfPoints(); ++n) {
    const Eigen::Vector3d place(grid->GetPoint(n));
    if (!place.allFinite())
      throw std::invalid_argument("point " + std::to_string(n) + " has a coordinate that is not a number");
    mesh.nodes.push_back(unit * place);
    mesh.node_numbers.push_back(number_of(ids, n));
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) add_cell(mesh, grid, cell);
  results::drop_unused_nodes(mesh);
  results::check_solid_mesh(mesh);
  return mesh;
}

void write_vtu(const std::filesystem::path& file, const SolidMesh& mesh,
               const std::vector<PointArray>& node_arrays, const std::vector<PointArray>& element_arrays) {
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto node_numbers = numbers_array(), element_numbers = numbers_array();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    points->InsertNextPoint(mesh.nodes[n].data());
    node_numbers->InsertNextValue(static_cast<vtkIdType>(mesh.node_numbers[n]));
  }
  grid->SetPoints(points);
  for (const auto& element : mesh.elements) {
    const auto& kind = results::kind_of(element.shape);
    std::array<vtkIdType, 20> nodes{};
    std::copy(element.nodes.begin(), element.nodes.end(), nodes.begin());
    grid->InsertNextCell(kind.vtk, kind.nodes, nodes.data());
    element_numbers->InsertNextValue(static_cast<vtkIdType>(element.number));
  }
  grid->GetPointData()->AddArray(node_numbers);
  grid->GetCellData()->AddArray(element_numbers);
  add_arrays(grid->GetPointData(), node_arrays, mesh.nodes.size());
  add_arrays(grid->GetCellData(), element_arrays, mesh.elements.size());
  const auto writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  writer->SetInputData(grid);
  // Appended data, the default, are not read by VTK 9.1 and ParaView 5.11 with the expat of Debian 12's
  // updates.
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  results::write_text_atomically(file, writer->GetOutputString());
}

}  // namespace diefill::render
