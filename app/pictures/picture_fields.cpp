// Pictures of fields: maps, sections, differences, velocities, displacements.
#include <algorithm>
#include <cmath>
#include <iterator>
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
#include "process/results/places_without_value.h"
#include "render/fields/arrow_map.h"
#include "render/fields/difference_map.h"
#include "render/fields/field_places.h"
#include "render/style/colour_bar.h"

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

/// Takes the value, from the top of each column, of the cells that the powder's surface cuts through: they
/// hold less than three quarters of what half of all cells hold.
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
        if (value > 0) value = results::unvalued_powder();
      }
}

/// Slow powder in mm/s, so that the numbers stay readable; all in one unit.
void use_readable_unit(std::vector<results::ArrowField>& all) {
  constexpr double kSlow = 0.02;  // m/s
  const bool slow = std::ranges::all_of(
      all, [](const auto& arrows) { return render::robust_range(arrows.field.value).upper <= kSlow; });
  for (auto& arrows : all) {
    arrows.unit = slow ? "mm/s" : "m/s";
    if (!slow) continue;
    for (double& value : arrows.field.value) value *= 1e3;
    for (auto& arrow : arrows.arrows) {
      arrow.along_first *= 1e3;
      arrow.along_second *= 1e3;
    }
  }
}

/// Draws the arrows of each source as kind.png, with one scale of colours and one of lengths for all;
/// `styles` and `subtitles` have what differs.
Pictures write_arrows(const PictureRequest& request, const std::string& kind, const std::string& quantity,
                      const std::vector<results::ArrowField>& all, std::vector<render::FieldStyle> styles,
                      const std::vector<std::string>& subtitles) {
  const render::ArrowScale scale = render::common_scale(all);
  Pictures written;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto& source = request.sources[n];
    styles[n].pixels = pixels_of(request);
    styles[n].arrow_length = scale.arrow_length;
    const auto picture =
        render::compose_arrows(all[n], quantity, title_of(request, source), subtitles[n],
                               std::isnan(request.upper) ? scale.upper : request.upper, styles[n]);
    written.push_back(write_picture(request, file_of(request, kind, source), picture.image));
  }
  return written;
}

/// One difference and what its picture says of it.
struct Difference {
  results::Field2D change;
  std::string title, compared;
  std::filesystem::path file;
  double fill_plane;  ///< mm above the cavity's floor
};

Difference difference_of(const results::Field2D& before, const results::Field2D& after,
                         const results::CavityState& cavity) {
  Difference made{process::difference(before, after), {}, {}, {}, 0};
  made.change.quantity = std::string("change of solid fraction");
  made.fill_plane = 1e3 * (cavity.upper_corner.z() - cavity.lower_corner.z());
  return made;
}

/// All on one scale, symmetric about zero.
Pictures write_differences(const PictureRequest& request, const std::vector<Difference>& differences) {
  std::vector<double> values;
  for (const auto& one : differences)
    values.insert(values.end(), one.change.value.begin(), one.change.value.end());
  const double limit = render::make_diverging_bar({}, values, request.upper).range.upper;
  Pictures written;
  for (const auto& one : differences) {
    render::FieldStyle style;
    style.pixels = pixels_of(request);
    style.fill_plane = one.fill_plane;
    const auto picture = render::compose_difference(one.change, one.title, one.compared, limit, style);
    written.push_back(write_picture(request, one.file, picture.image));
  }
  return written;
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
    render::add_map_places(style, source.result, fields[n]);
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
  for (const auto& source : request.sources) {
    fields.push_back(process::plane_section(source.result.powder, source.result.solid_fraction,
                                            source.result.tools, request.plane, request.averaging_width)
                         .field);
    require_powder_near_plane(request, source, "section", fields.back());
  }
  const std::vector<results::SectionPlane> planes(fields.size(), request.plane);
  return write_fields(request, "section", fields, planes, style_of(request));
}

Pictures make_difference(const PictureRequest& request) {
  require_ring(request, "difference", "plan-map of each result");
  std::vector<Difference> differences;
  const auto& first = request.sources.front();
  if (request.from || request.to || request.sources.size() == 1) {
    for (const auto& source : request.sources) {
      const TwoInstants two = two_instants(request, source);
      differences.push_back(
          difference_of(map_of(request, two.before), map_of(request, two.after), source.result.cavity));
      differences.back().title = title_of(request, source);
      differences.back().compared = "Change from " + span_of(two);
      differences.back().file = file_of(request, "difference", source);
    }
    return write_differences(request, differences);
  }
  const auto reference = map_of(request, first.result);
  for (std::size_t n = 1; n < request.sources.size(); ++n) {
    const auto& source = request.sources[n];
    differences.push_back(difference_of(reference, map_of(request, source.result), source.result.cavity));
    differences.back().title = source.name + " minus " + first.name;
    differences.back().compared = source.result.strategy + " compared with " + first.result.strategy;
    differences.back().file = file_of(request, "difference", source);
  }
  return write_differences(request, differences);
}

Pictures make_displacement(const PictureRequest& request) {
  require_ring(request, "displacement", "velocity-section");
  std::vector<results::ArrowField> all;
  std::vector<std::string> subtitles;
  for (const auto& source : request.sources) {
    const TwoInstants two = two_instants(request, source);
    all.push_back(process::unrolled_vectors(
        process::displacements(two.before.powder, two.after.powder, two.after.cavity), two.after.cavity,
        two.after.powder.grain_diameter, request.averaging_width));
    all.back().unit = "mm";
    subtitles.push_back(source.result.powder_name + ", " + span_of(two));
  }
  return write_arrows(request, "displacement", "displacement", all,
                      std::vector<render::FieldStyle>(all.size()), subtitles);
}

Pictures make_velocity_map(const PictureRequest& request) {
  require_ring(request, "velocity", "velocity-section");
  std::vector<results::ArrowField> all;
  std::vector<render::FieldStyle> styles;
  std::vector<std::string> subtitles;
  for (const auto& source : request.sources) {
    const auto& powder = source.result.powder;
    all.push_back(process::unrolled_vectors(process::velocities(powder), source.result.cavity,
                                            powder.grain_diameter, request.averaging_width));
    styles.emplace_back();
    render::add_map_places(styles.back(), source.result, all.back().field);
    subtitles.push_back(subtitle_of(source));
  }
  use_readable_unit(all);
  return write_arrows(request, "velocity", "velocity", all, std::move(styles), subtitles);
}

Pictures make_velocity_section(const PictureRequest& request) {
  std::vector<results::ArrowField> all;
  std::vector<render::FieldStyle> styles;
  std::vector<std::string> subtitles;
  for (const auto& source : request.sources) {
    all.push_back(process::plane_vectors(process::velocities(source.result.powder), source.result,
                                         request.plane, request.averaging_width));
    require_powder_near_plane(request, source, "velocity-section", all.back().field);
    styles.emplace_back();
    render::add_section_places(styles.back(), source.result, request.plane);
    subtitles.push_back(subtitle_of(source) + ", " + render::section_text(request.plane));
  }
  use_readable_unit(all);
  return write_arrows(request, "velocity_section", "velocity", all, std::move(styles), subtitles);
}

}  // namespace diefill::app
