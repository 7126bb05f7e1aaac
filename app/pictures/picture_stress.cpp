// Pictures of the stress in the powder.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/measure/fields/plane_sample.h"
#include "process/measure/fields/ring_sample.h"
#include "process/measure/fields/stress_field.h"

namespace diefill::app {
namespace {

constexpr double kKilopascal = 1e3;

/// Largest magnitude of all values.
double largest(const std::vector<results::Field2D>& fields) {
  double found = 0;
  for (const auto& field : fields)
    for (const double value : field.value)
      if (std::isfinite(value)) found = std::max(found, std::abs(value));
  return found;
}

/// One field of pressure for each source, given in kPa and shown in Pa where all are below 1 kPa, and the
/// pictures of all on one scale.
Pictures draw_pressures(const PictureRequest& request, const std::string& kind,
                        std::vector<results::Field2D> fields,
                        const std::vector<results::SectionPlane>& planes) {
  for (auto& field : fields) field.quantity = std::string("pressure");
  render::FieldStyle style;
  style.unit = "kPa";
  const bool limits_given = !std::isnan(request.lower) || !std::isnan(request.upper);  // they are in kPa
  if (!limits_given && largest(fields) < 1) {
    style.unit = "Pa";
    for (auto& field : fields)
      for (double& value : field.value)
        if (std::isfinite(value)) value *= kKilopascal;
  }
  style.note = "one third of the trace of the stress from contacts and motion; compression positive";
  return write_fields(request, kind, fields, planes, style);
}

}  // namespace

Pictures make_pressure_map(const PictureRequest& request) {
  require_ring(request, "pressure", "pressure-section");
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources) {
    const process::StressField stress(source.result, request.averaging_width);
    fields.push_back(process::sample_ring(
        source.result.powder, source.result.tools, source.result.cavity, request.averaging_width,
        [&](const Eigen::Vector3d& point) { return stress.pressure(point) / kKilopascal; }));
  }
  return draw_pressures(request, "pressure", std::move(fields), {});
}

Pictures make_pressure_section(const PictureRequest& request) {
  std::vector<results::Field2D> fields;
  std::vector<results::SectionPlane> planes;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    const auto plane = request.plane_given ? request.plane : result.sections.front().plane;
    const process::StressField stress(result, request.averaging_width);
    fields.push_back(process::sample_plane(
                         result.powder, result.solid_fraction, result.tools, plane, request.averaging_width,
                         [&](const Eigen::Vector3d& point) { return stress.pressure(point) / kKilopascal; })
                         .field);
    if (fields.back().first.empty())
      throw std::invalid_argument("pressure-section: no powder near the plane; move it with --origin");
    planes.push_back(plane);
  }
  return draw_pressures(request, "pressure_section", std::move(fields), planes);
}

}  // namespace diefill::app
