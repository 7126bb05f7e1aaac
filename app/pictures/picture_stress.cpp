// Pictures of the stress in the powder.
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/pictures/picture_files.h"
#include "app/pictures/sampled_fields.h"
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

/// kPa.
ValueOfResult pressure_with(double averaging_width) {
  return [averaging_width](const results::FillResult& result) -> process::PlaneValue {
    const auto stress = std::make_shared<const process::StressField>(result, averaging_width);
    return [stress](const Eigen::Vector3d& point) { return stress->pressure(point) / kKilopascal; };
  };
}

/// The pictures of all sources on one scale, in Pa where all pressures are below 1 kPa.
Pictures draw_pressures(const PictureRequest& request, const std::string& kind, SampledFields sampled) {
  auto& fields = sampled.fields;
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
  return write_fields(request, kind, fields, sampled.planes, style);
}

}  // namespace

Pictures make_pressure_map(const PictureRequest& request) {
  require_ring(request, "pressure", "pressure-section");
  return draw_pressures(request, "pressure", sampled_maps(request, pressure_with(request.averaging_width)));
}

Pictures make_pressure_section(const PictureRequest& request) {
  return draw_pressures(
      request, "pressure_section",
      sampled_sections(request, "pressure-section", pressure_with(request.averaging_width)));
}

}  // namespace diefill::app
