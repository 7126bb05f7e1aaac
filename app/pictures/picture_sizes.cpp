// Pictures of where large and small grains lie.
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/measure/fields/plane_sample.h"
#include "process/measure/fields/ring_sample.h"
#include "process/measure/figures/segregation.h"

namespace diefill::app {
namespace {

/// Draws one field a source, all on one scale; `planes`: of sections, empty for maps.
Pictures draw_sizes(const PictureRequest& request, const std::string& name,
                    std::vector<results::Field2D> fields, const std::vector<results::SectionPlane>& planes) {
  for (auto& field : fields) field.quantity = std::string("mean grain diameter");
  render::FieldStyle style;
  style.unit = "mm";
  style.note = "weighted by mass";
  return write_fields(request, name, fields, planes, style);
}

}  // namespace

Pictures make_size_map(const PictureRequest& request) {
  require_ring(request, "size-map", "size-section");
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources) {
    const process::SizeField size(source.result.powder, request.averaging_width);
    fields.push_back(process::sample_ring(source.result.powder, source.result.tools, source.result.cavity,
                                          request.averaging_width,
                                          [&](const Eigen::Vector3d& point) { return size.at(point); }));
  }
  return draw_sizes(request, "size_map", std::move(fields), {});
}

Pictures make_size_section(const PictureRequest& request) {
  std::vector<results::Field2D> fields;
  std::vector<results::SectionPlane> planes;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    const auto plane = request.plane_given ? request.plane : result.sections.front().plane;
    const process::SizeField size(result.powder, request.averaging_width);
    fields.push_back(process::sample_plane(result.powder, result.solid_fraction, result.tools, plane,
                                           request.averaging_width,
                                           [&](const Eigen::Vector3d& point) { return size.at(point); })
                         .field);
    if (fields.back().first.empty())
      throw std::invalid_argument("size-section: no powder near the plane; move it with --origin");
    planes.push_back(plane);
  }
  return draw_sizes(request, "size_section", std::move(fields), planes);
}

}  // namespace diefill::app
