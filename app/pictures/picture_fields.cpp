// Pictures of fields: maps, sections, differences, velocities, displacements.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/measure/earlier_instant.h"
#include "process/measure/fields/box_map.h"
#include "process/measure/fields/motion_field.h"
#include "process/measure/figures/variation.h"
#include "process/measure/measure.h"
#include "process/measure/volumes/partial_volumes.h"
#include "process/results/formatted.h"
#include "render/fields/arrow_map.h"
#include "render/fields/difference_map.h"
#include "render/fields/field_places.h"

namespace diefill::app {
namespace {

std::string in_seconds(double time) {
  return results::formatted("%.3f s", time);
}

results::Field2D map_of(const PictureRequest& request, const results::FillResult& result) {
  return process::cylindrical_map(result.powder, result.solid_fraction, result.tools, result.cavity,
                                  request.averaging_width);
}

render::FieldStyle style_of(const PictureRequest& request) {
  render::FieldStyle style;
  style.mark_mean = true;
  style.pixels = pixels_of(request);
  return style;
}

results::Field2D partial_volume_map_of(const PictureRequest& request, const results::FillResult& result) {
  const auto& cavity = result.cavity;
  const double depth = cavity.upper_corner.z() - cavity.lower_corner.z();
  // Cells of two averaging widths each way: as much powder in each as a Gaussian weighs.
  const double cell = 2 * request.averaging_width;
  const int round =
      static_cast<int>(std::lround(std::numbers::pi * (cavity.inner_radius + cavity.outer_radius) / cell));
  return process::partial_volume_map(result.powder, cavity, std::clamp(round, 8, 360),
                                     std::clamp(static_cast<int>(std::lround(depth / cell)), 4, 240));
}

/// The outermost rows again on the cavity's floor and fill plane, so that the picture covers its whole depth.
results::Field2D over_whole_depth(results::Field2D map, const results::CavityState& cavity) {
  const double depth = 1e3 * (cavity.upper_corner.z() - cavity.lower_corner.z());
  const auto columns = static_cast<std::ptrdiff_t>(map.first.size());
  const std::vector<double> lowest(map.value.begin(), map.value.begin() + columns);
  const std::vector<double> highest(map.value.end() - columns, map.value.end());
  map.value.insert(map.value.begin(), lowest.begin(), lowest.end());
  map.value.insert(map.value.end(), highest.begin(), highest.end());
  map.second.insert(map.second.begin(), 0);
  map.second.push_back(depth);
  return map;
}

/// Leaves out, from the top of each column, the cells that the powder's surface cuts through: they hold less
/// than three quarters of what half of all cells hold.
void leave_out_cut_cells(std::vector<results::Field2D>& fields) {
  constexpr double kFull = 0.75;  // of the median
  std::vector<double> values;
  for (const auto& field : fields)
    std::copy_if(field.value.begin(), field.value.end(), std::back_inserter(values),
                 [](double value) { return std::isfinite(value); });
  if (values.empty()) return;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const double least = kFull * *middle;
  for (auto& field : fields)
    for (std::size_t i = 0; i < field.first.size(); ++i)
      for (std::size_t j = field.second.size(); j-- > 0;) {
        double& value = field.value[j * field.first.size() + i];
        if (value >= least) break;
        value = std::numeric_limits<double>::quiet_NaN();
      }
}

/// Slow powder in mm/s, so that the numbers stay readable.
results::ArrowField in_readable_unit(results::ArrowField arrows) {
  constexpr double kSlow = 0.02;  // m/s
  arrows.unit = "m/s";
  if (render::robust_range(arrows.field.value).upper > kSlow) return arrows;
  arrows.unit = "mm/s";
  for (double& value : arrows.field.value) value *= 1e3;
  for (auto& arrow : arrows.arrows) {
    arrow.along_first *= 1e3;
    arrow.along_second *= 1e3;
  }
  return arrows;
}

void draw_difference(const PictureRequest& request, const results::Field2D& before,
                     const results::Field2D& after, const std::string& title, const std::string& compared,
                     const std::filesystem::path& file, Pictures& written) {
  auto change = process::difference(before, after);
  change.quantity = std::string("change of solid fraction");
  render::FieldStyle style;
  style.pixels = pixels_of(request);
  const auto picture = render::compose_difference(change, title, compared, request.upper, style);
  written.push_back(write_picture(request, file, picture.image));
}

struct TwoInstants {
  results::FillResult before, after;
};

TwoInstants two_instants(const PictureRequest& request, const PictureSource& source) {
  const auto& result = source.result;
  if (!request.from && result.instants.empty()) process::result_at(result, -1);  // says what is missing
  const double from = request.from ? *request.from : result.instants.back().time;
  TwoInstants two{process::result_at(result, from),
                  request.to ? process::result_at(result, *request.to) : result};
  if (two.before.powder.time >= two.after.powder.time)
    throw std::invalid_argument("--from " + in_seconds(two.before.powder.time) + " must come before --to " +
                                in_seconds(two.after.powder.time));
  return two;
}

std::string span_of(const TwoInstants& two) {
  return "t = " + in_seconds(two.before.powder.time) + " to " + in_seconds(two.after.powder.time);
}

}  // namespace

Pictures make_map(const PictureRequest& request) {
  require_ring(request, "map", "plan-map or section");
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources) fields.push_back(map_of(request, source.result));
  return write_fields(request, "map", fields, {}, style_of(request));
}

Pictures make_plan_map(const PictureRequest& request) {
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources)
    fields.push_back(process::box_map(source.result, process::BoxView::kPlan, request.averaging_width));
  render::FieldStyle style = style_of(request);
  style.note = "mean over the height of the powder";
  return write_fields(request, "plan_map", fields, {}, style, ", seen from above");
}

Pictures make_fill_level_map(const PictureRequest& request) {
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources) fields.push_back(process::fill_level_map(source.result));
  render::FieldStyle style = style_of(request);
  style.unit = "mm";
  style.note = "height of the powder surface above the cavity floor";
  return write_fields(request, "fill_level_map", fields, {}, style, ", seen from above");
}

Pictures make_partial_volume_map(const PictureRequest& request) {
  require_ring(request, "partial-volumes", "plan-map or section");
  std::vector<results::Field2D> fields;
  for (const auto& source : request.sources)
    fields.push_back(over_whole_depth(partial_volume_map_of(request, source.result), source.result.cavity));
  leave_out_cut_cells(fields);
  const auto range = shared_range(request, fields);
  Pictures written;
  for (std::size_t n = 0; n < fields.size(); ++n) {
    const auto& source = request.sources[n];
    render::FieldStyle style;
    style.pixels = pixels_of(request);
    style.note =
        "exact partial volumes of cells over the whole ring width; cells cut by the surface are omitted";
    const auto picture =
        render::compose_field(fields[n], title_of(request, source), subtitle_of(source), range, style);
    written.push_back(write_picture(request, file_of(request, "partial_volumes", source), picture.image));
  }
  return written;
}

Pictures make_section(const PictureRequest& request) {
  std::vector<results::Field2D> fields;
  std::vector<results::SectionPlane> planes;
  for (const auto& source : request.sources) {
    planes.push_back(request.plane_given ? request.plane : source.result.sections.front().plane);
    fields.push_back(process::plane_section(source.result.powder, source.result.solid_fraction,
                                            source.result.tools, planes.back(), request.averaging_width)
                         .field);
    if (fields.back().first.empty())
      throw std::invalid_argument("section: no powder near the plane; move it with --origin");
  }
  return write_fields(request, "section", fields, planes, style_of(request));
}

Pictures make_difference(const PictureRequest& request) {
  require_ring(request, "difference", "plan-map of each result");
  Pictures written;
  const auto& first = request.sources.front();
  if (request.from || request.to || request.sources.size() == 1) {
    for (const auto& source : request.sources) {
      const TwoInstants two = two_instants(request, source);
      draw_difference(request, map_of(request, two.before), map_of(request, two.after),
                      title_of(request, source), "Change from " + span_of(two),
                      file_of(request, "difference", source), written);
    }
    return written;
  }
  const auto reference = map_of(request, first.result);
  for (std::size_t n = 1; n < request.sources.size(); ++n) {
    const auto& source = request.sources[n];
    draw_difference(request, reference, map_of(request, source.result), source.name + " minus " + first.name,
                    source.result.strategy + " compared with " + first.result.strategy,
                    file_of(request, "difference", source), written);
  }
  return written;
}

Pictures make_displacement(const PictureRequest& request) {
  require_ring(request, "displacement", "velocity-section");
  Pictures written;
  for (const auto& source : request.sources) {
    const TwoInstants two = two_instants(request, source);
    auto arrows = process::unrolled_vectors(
        process::displacements(two.before.powder, two.after.powder, two.after.cavity), two.after.cavity,
        two.after.powder.grain_diameter, request.averaging_width);
    arrows.unit = "mm";
    render::FieldStyle style;
    style.pixels = pixels_of(request);
    const auto picture =
        render::compose_arrows(arrows, "displacement", title_of(request, source),
                               source.result.powder_name + ", " + span_of(two), request.upper, style);
    written.push_back(write_picture(request, file_of(request, "displacement", source), picture.image));
  }
  return written;
}

Pictures make_velocity_map(const PictureRequest& request) {
  require_ring(request, "velocity", "velocity-section");
  Pictures written;
  for (const auto& source : request.sources) {
    const auto arrows = in_readable_unit(
        process::unrolled_vectors(process::velocities(source.result.powder), source.result.cavity,
                                  source.result.powder.grain_diameter, request.averaging_width));
    render::FieldStyle style;
    style.pixels = pixels_of(request);
    const auto picture = render::compose_arrows(arrows, "velocity", title_of(request, source),
                                                subtitle_of(source), request.upper, style);
    written.push_back(write_picture(request, file_of(request, "velocity", source), picture.image));
  }
  return written;
}

Pictures make_velocity_section(const PictureRequest& request) {
  Pictures written;
  for (const auto& source : request.sources) {
    const auto plane = request.plane_given ? request.plane : source.result.sections.front().plane;
    auto arrows = process::plane_vectors(process::velocities(source.result.powder), source.result, plane,
                                         request.averaging_width);
    if (arrows.field.first.empty())
      throw std::invalid_argument("velocity-section: no powder near the plane; move it with --origin");
    arrows = in_readable_unit(std::move(arrows));
    render::FieldStyle style;
    style.pixels = pixels_of(request);
    render::add_section_places(style, source.result, plane);
    const auto picture = render::compose_arrows(arrows, "velocity", title_of(request, source),
                                                subtitle_of(source) + ", " + render::section_text(plane),
                                                request.upper, style);
    written.push_back(write_picture(request, file_of(request, "velocity_section", source), picture.image));
  }
  return written;
}

}  // namespace diefill::app
