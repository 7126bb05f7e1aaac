#include "render/scene3d/grain_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLightKit.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/offscreen/offscreen.h"
#include "render/scene3d/cut_tools.h"
#include "render/scene3d/traced_view.h"

namespace diefill::render {
namespace {

constexpr int kOversampling = 2;
constexpr const char* kRadius = "radius";

// Spheres of the grains whose centre lies behind the cut; whole grains, so that none is drawn in part.
vtkSmartPointer<vtkPolyData> spheres_behind_cut(const results::PowderState& powder,
                                                const std::vector<Rgb>& grain_colours, double cut_y) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetName("colour");
  colours->SetNumberOfComponents(3);
  const auto radii = vtkSmartPointer<vtkFloatArray>::New();
  radii->SetName(kRadius);
  const auto centres = powder.sphere_centres();
  const auto sphere_radii = powder.radii_of_spheres();
  const auto grains = powder.grains_of_spheres();
  for (std::size_t n = 0; n < centres.size(); ++n) {
    if (powder.position[grains[n]].y() < cut_y) continue;
    const Eigen::Vector3d centre = kMillimetres * centres[n];
    points->InsertNextPoint(centre.data());
    colours->InsertNextTypedTuple(&grain_colours[grains[n]].red);
    radii->InsertNextValue(static_cast<float>(kMillimetres * sphere_radii[n]));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetScalars(colours);
  data->GetPointData()->AddArray(radii);
  // Without cells VTK takes the data for empty, and draws nothing.
  const auto all_points = vtkSmartPointer<vtkCellArray>::New();
  all_points->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k) all_points->InsertCellPoint(k);
  data->SetVerts(all_points);
  return data;
}

void add_powder(vtkRenderer* renderer, const results::PowderState& powder,
                const std::vector<Rgb>& grain_colours, double cut_y) {
  const auto data = spheres_behind_cut(powder, grain_colours, cut_y);
  if (data->GetNumberOfPoints() == 0) return;
  const auto mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
  mapper->SetInputData(data);
  if (powder.equal_spheres())
    mapper->SetRadius(static_cast<float>(kMillimetres * powder.sphere_radius));
  else
    mapper->SetScaleArray(kRadius);
  mapper->SetScalarModeToUsePointData();
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.80);
  actor->GetProperty()->SetSpecular(0.10);
  actor->GetProperty()->SetSpecularPower(15);
  renderer->AddActor(actor);
}

void place_camera(vtkRenderer* renderer, const ViewChoice& view) {
  const double distance = 10 * kMillimetres * std::max(view.width, view.height);
  const Eigen::Vector3d target = kMillimetres * view.target;
  const ViewAxes axes = view_axes(view);
  const Eigen::Vector3d eye = target + distance * axes.to_eye;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(target.x(), target.y(), target.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(axes.up.x(), axes.up.y(), axes.up.z());
  camera->SetParallelScale(0.5 * kMillimetres * view.height);
  renderer->ResetCameraClippingRange();
}

// Darkens what lies deep between grains: looks two grain diameters round every point. VTK keeps places seen
// from the eye in half precision: the eye comes as near as the scene allows, and what is closer than three
// steps of that is no hollow.
void add_ambient_occlusion(vtkRenderer* renderer, double grain_diameter) {
  constexpr double kHalfPrecision = 1.0 / 1024;
  std::array<double, 6> bounds{};
  renderer->ComputeVisiblePropBounds(bounds.data());
  const double distance = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d target(camera->GetFocalPoint()), eye(camera->GetPosition());
  const Eigen::Vector3d nearer = target + distance * (eye - target).normalized();
  camera->SetPosition(nearer.x(), nearer.y(), nearer.z());
  renderer->ResetCameraClippingRange();
  const auto basic = vtkSmartPointer<vtkRenderStepsPass>::New();
  const auto occlusion = vtkSmartPointer<vtkSSAOPass>::New();
  occlusion->SetRadius(2 * kMillimetres * grain_diameter);
  occlusion->SetBias(std::max(0.05 * kMillimetres * grain_diameter, 3 * kHalfPrecision * distance));
  occlusion->SetKernelSize(64);
  occlusion->BlurOn();
  occlusion->SetDelegatePass(basic);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(occlusion);
}

QImage read_back(OffscreenWindow& window, int width, int height) {
  const auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0);
  // VTK's rows run from the bottom up.
  return QImage(pixels->GetPointer(0), width, height, 3 * width, QImage::Format_RGB888).mirrored();
}

Renderer& chosen_renderer() {
  static Renderer chosen = Renderer::kOpenGl;
  return chosen;
}

}  // namespace

Renderer renderer() {
  return chosen_renderer();
}

void set_renderer(Renderer chosen) {
  chosen_renderer() = chosen;
}

QImage draw_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                   const ViewChoice& view, int width, int height, const SceneLook& look) {
  if (look.drawn_by == Renderer::kEmbree)
    return trace_grains(result, grain_colours, view, width, height, look);
  const auto window = vtkSmartPointer<OffscreenWindow>::New();
  window->open(kOversampling * width, kOversampling * height);
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  constexpr double kUncut = -1e6;  // m: before anything
  add_powder(renderer, result.powder, grain_colours, look.cut_powder ? view.cut_y : kUncut);
  const bool whole = look.tools == ToolLook::kTranslucent;
  for (const auto& tool : result.tools) {
    if (look.tools == ToolLook::kHidden) break;
    const auto actor = make_cut_tool(tool, whole ? kUncut : view.cut_y);
    if (!actor) continue;
    if (whole) actor->GetProperty()->SetOpacity(kTranslucency);
    renderer->AddActor(actor);
  }
  if (whole) renderer->UseDepthPeelingOn();
  renderer->AutomaticLightCreationOff();
  const auto lights = vtkSmartPointer<vtkLightKit>::New();
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyLightWarmth(0.5);
  lights->SetFillLightWarmth(0.5);
  lights->SetHeadLightWarmth(0.5);
  lights->SetBackLightWarmth(0.5);
  lights->AddLightsToRenderer(renderer);
  place_camera(renderer, view);
  if (look.ambient_occlusion) add_ambient_occlusion(renderer, result.powder.grain_diameter);
  window->Render();
  const QImage large = read_back(*window, kOversampling * width, kOversampling * height);
  return large.scaled(width, height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_RGB32);
}

}  // namespace diefill::render
