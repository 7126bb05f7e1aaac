#include "render/scene3d/cut_tools.h"

#include <vtkCellData.h>
#include <vtkClipClosedSurface.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <array>

#include "render/scene3d/mesh_polydata.h"

namespace diefill::render {
namespace {

struct Tone {
  std::array<double, 3> surface, cut;
};

// Slightly different shades of steel, so that die, core, punch and shoe can be distinguished where they
// touch.
Tone tone_of(const std::string& role) {
  if (role == "core") return {{0.80, 0.82, 0.86}, {0.62, 0.65, 0.71}};
  if (role == "punch") return {{0.74, 0.77, 0.82}, {0.50, 0.54, 0.62}};
  if (role == "shoe") return {{0.90, 0.85, 0.76}, {0.72, 0.64, 0.51}};
  return {{0.84, 0.86, 0.89}, {0.69, 0.72, 0.77}};
}

}  // namespace

vtkSmartPointer<vtkPolyData> cut_surface(const results::ToolState& tool, double cut_y) {
  if (tool.triangles.empty()) return nullptr;
  const Tone tone = tone_of(tool.role);
  const auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(0, kMillimetres * cut_y, 0);
  plane->SetNormal(0, 1, 0);
  const auto planes = vtkSmartPointer<vtkPlaneCollection>::New();
  planes->AddItem(plane);
  const auto clip = vtkSmartPointer<vtkClipClosedSurface>::New();
  clip->SetInputData(mesh_polydata(tool.vertices, tool.triangles));
  clip->SetClippingPlanes(planes);
  clip->SetScalarModeToColors();
  clip->SetBaseColor(tone.surface[0], tone.surface[1], tone.surface[2]);
  clip->SetClipColor(tone.cut[0], tone.cut[1], tone.cut[2]);
  const auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
  normals->SetInputConnection(clip->GetOutputPort());
  normals->SetFeatureAngle(30);
  normals->ConsistencyOff();
  normals->Update();
  if (normals->GetOutput()->GetNumberOfCells() == 0) return nullptr;
  return normals->GetOutput();
}

vtkSmartPointer<vtkActor> make_cut_tool(const results::ToolState& tool, double cut_y) {
  const auto surface = cut_surface(tool, cut_y);
  if (!surface) return nullptr;
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(surface);
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.18);
  actor->GetProperty()->SetDiffuse(0.80);
  actor->GetProperty()->SetSpecular(0.25);
  actor->GetProperty()->SetSpecularPower(25);
  return actor;
}

}  // namespace diefill::render
