#include "render/scene3d/traced_view.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <optional>

#include "render/scene3d/cut_tools.h"
#include "render/tracing/traced_image.h"

namespace diefill::render {
namespace {

constexpr double kUncut = -1e6;  // m: before anything

/// Everything in mm from the middle of the view, where single precision is finest.
class SceneParts {
 public:
  explicit SceneParts(const ViewChoice& view) : centre_(view.target) {}

  void add_powder(const results::PowderState& powder, const std::vector<Rgb>& grain_colours, double cut_y) {
    const auto centres = powder.sphere_centres();
    const auto radii = powder.radii_of_spheres();
    const auto grains = powder.grains_of_spheres();
    for (std::size_t n = 0; n < centres.size(); ++n) {
      if (powder.position[grains[n]].y() < cut_y) continue;
      const Eigen::Vector3f place = (kMillimetres * (centres[n] - centre_)).cast<float>();
      const auto radius = static_cast<float>(kMillimetres * radii[n]);
      spheres.spheres.emplace_back(place.x(), place.y(), place.z(), radius);
      spheres.colours.push_back(grain_colours[grains[n]]);
      farthest = std::max(farthest, place.norm() + radius);
    }
  }

  void add_tool(const results::ToolState& tool, double cut_y) {
    const auto surface = cut_surface(tool, cut_y);
    if (!surface) return;
    const auto filter = vtkSmartPointer<vtkTriangleFilter>::New();
    filter->PassVertsOff();
    filter->PassLinesOff();
    filter->SetInputData(surface);
    filter->Update();
    add_surface(filter->GetOutput());
  }

  TracedSpheres spheres;
  TracedTriangles triangles;
  float farthest = 0;  ///< of anything from the middle

 private:
  void add_surface(vtkPolyData* surface) {
    const auto first = static_cast<std::uint32_t>(triangles.corners.size());
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n) {
      const Eigen::Vector3d place = Eigen::Vector3d(surface->GetPoint(n)) - kMillimetres * centre_;
      triangles.corners.push_back(place.cast<float>());
      triangles.normals.push_back(Eigen::Vector3d(normals->GetTuple3(n)).cast<float>());
      farthest = std::max(farthest, triangles.corners.back().norm());
    }
    vtkDataArray* colours = surface->GetCellData()->GetScalars();
    const auto corners = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell) {
      surface->GetCellPoints(cell, corners);
      if (corners->GetNumberOfIds() != 3) continue;
      const auto corner = [&](vtkIdType n) { return first + static_cast<std::uint32_t>(corners->GetId(n)); };
      triangles.triangles.emplace_back(corner(0), corner(1), corner(2));
      const double* colour = colours->GetTuple3(cell);
      triangles.colours.push_back({static_cast<std::uint8_t>(colour[0]), static_cast<std::uint8_t>(colour[1]),
                                   static_cast<std::uint8_t>(colour[2])});
    }
  }

  Eigen::Vector3d centre_;
};

TracedCamera camera_of(const ViewChoice& view, float farthest) {
  const ViewAxes axes = view_axes(view);
  TracedCamera camera;
  camera.right = axes.right.cast<float>();
  camera.up = axes.up.cast<float>();
  camera.to_eye = axes.to_eye.cast<float>();
  camera.height = static_cast<float>(kMillimetres * view.height);
  camera.distance = 1.01F * farthest;
  return camera;
}

}  // namespace

QImage trace_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                    const ViewChoice& view, int width, int height, const SceneLook& look) {
  constexpr float kGapOverDiameter = 4, kGapOverHeight = 0.08F;
  SceneParts parts(view);
  parts.add_powder(result.powder, grain_colours, look.cut_powder ? view.cut_y : kUncut);
  const bool whole = look.tools == ToolLook::kTranslucent;
  SceneParts glass(view);
  for (const auto& tool : result.tools) {
    if (look.tools == ToolLook::kHidden) break;
    (whole ? glass : parts).add_tool(tool, whole ? kUncut : view.cut_y);
  }
  const float farthest = std::max(parts.farthest, glass.farthest);
  TracedLight light;
  light.gap = result.powder.grain_diameter > 0
                  ? kGapOverDiameter * static_cast<float>(kMillimetres * result.powder.grain_diameter)
                  : kGapOverHeight * static_cast<float>(kMillimetres * view.height);
  const RayScene scene(std::move(parts.spheres), std::move(parts.triangles));
  std::optional<RayScene> translucent;
  if (whole) translucent.emplace(std::move(glass.spheres), std::move(glass.triangles));
  return trace_image(scene, translucent ? &*translucent : nullptr, static_cast<float>(kTranslucency),
                     camera_of(view, farthest), light, width, height);
}

}  // namespace diefill::render
