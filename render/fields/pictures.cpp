#include "render/fields/pictures.h"

#include <algorithm>
#include <cmath>

#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "render/fields/density_map.h"
#include "render/fields/field_places.h"
#include "render/fields/field_sampler.h"
#include "render/style/picture_file.h"
#include "render/style/ticks.h"

namespace diefill::render {
namespace {

constexpr const char* kSolidFraction = "solid fraction";
constexpr const char* kFillLevel = "fill level";

std::string subtitle_of(const results::FillResult& result) {
  std::string text = result.powder_name;
  if (result.powder.grain_diameter > 0) {
    text += (text.empty() ? "" : ", ") + ("grain size " + result.powder.sizes_text());
  }
  return text;
}

const std::string& title_of(const results::FillResult& result) {
  return result.strategy.empty() ? result.title : result.strategy;
}

/// A chart of a run, and the file that it goes to.
struct ProfileChart {
  const results::Profile* profile;
  std::string file;
  double fill_plane = std::nan("");  ///< mm above the cavity's floor, of fill levels
};

/// mm; NaN where the results do not hold it.
double depth_of(const results::FillResult& result, int cavity) {
  const auto other = static_cast<std::size_t>(std::max(cavity, 2)) - 2;
  if (cavity > 1 && other >= result.other_cavities.size()) return std::nan("");
  const auto& chosen = cavity > 1 ? result.other_cavities[other] : result.cavity;
  const double depth = 1e3 * (chosen.upper_corner.z() - chosen.lower_corner.z());
  return depth > 0 ? depth : std::nan("");
}

bool is_ring(const results::FillResult& result, int cavity) {
  if (cavity < 2) return result.cavity.is_ring;
  const auto other = static_cast<std::size_t>(cavity) - 2;
  return other < result.other_cavities.size() && result.other_cavities[other].is_ring;
}

/// What the charts of a run show, of each cavity: the fill level, and of those that are no rings the solid
/// fraction over height.
std::vector<ProfileChart> profile_charts(const results::FillResult& result) {
  std::vector<ProfileChart> charts;
  for (const auto& profile : result.profiles) {
    const auto [quantity, cavity] = results::quantity_and_cavity(profile.quantity);
    const bool level = quantity == kFillLevel;
    if (!level && (is_ring(result, cavity) || profile.x_name != "height")) continue;
    const std::string suffix = cavity > 1 ? "_cavity_" + std::to_string(cavity) : "";
    charts.push_back({&profile, (level ? "fill_level" : "height_profile") + suffix + ".png",
                      level ? depth_of(result, cavity) : std::nan("")});
  }
  if (charts.empty() && !result.profiles.empty()) {
    const std::string file = "height_profile.png";
    charts.push_back({&result.profiles.front(), file, std::nan("")});
  }
  return charts;
}

/// "Solid fraction over height, cavity 2".
std::string profile_title(const results::Profile& profile) {
  const auto [quantity, cavity] = results::quantity_and_cavity(profile.quantity);
  return results::capitalised(results::quantity_in_cavity(quantity + " over " + profile.x_name, cavity));
}

bool same_plane(const results::SectionPlane& one, const results::SectionPlane& other) {
  constexpr double kSame = 1e-9;
  return (one.normal - other.normal).norm() < kSame &&
         std::abs((one.origin - other.origin).dot(one.normal)) < kSame;
}

std::string map_name(const results::Field2D& map) {
  if (has_azimuth(map)) return "density_map";
  return map.quantity == kFillLevel ? "fill_level_map" : "plan_map";
}

void draw_map(const std::filesystem::path& png, const results::FillResult& result,
              const results::Field2D& map, const ColourRange& range) {
  FieldStyle style;
  style.mark_mean = true;
  add_map_places(style, result, map);
  const bool level = map.quantity == kFillLevel, plan = !has_azimuth(map);
  if (level) {
    style.unit = "mm";
    style.note = "height of the powder surface above the cavity floor";
  } else if (plan) {
    style.note = "mean over the height of the powder";
  }
  const std::string view(plan ? ", seen from above" : "");
  write_png(png, compose_field(map, title_of(result), subtitle_of(result) + view,
                               level ? kRangeFromData : range, style)
                     .image);
}

void draw_section(const std::filesystem::path& png, const results::FillResult& result,
                  const results::SectionField& section, const ColourRange& range) {
  FieldStyle style;
  style.mark_mean = true;
  add_section_places(style, result, section.plane);
  const std::string subtitle = subtitle_of(result) + ", " + section_text(section.plane);
  write_png(png, compose_field(section.field, title_of(result), subtitle, range, style).image);
}

}  // namespace

ColourRange solid_fraction_range(const std::vector<const results::FillResult*>& results) {
  std::vector<double> values;
  const auto add = [&values](const results::Field2D& field) {
    if (field.quantity == kSolidFraction) values.insert(values.end(), field.value.begin(), field.value.end());
  };
  for (const auto* result : results) {
    for (const auto& map : result->maps) add(map);
    for (const auto& section : result->sections) add(section.field);
  }
  if (std::ranges::none_of(values, [](double value) { return std::isfinite(value); })) return kRangeFromData;
  const Interval range = robust_range(values);
  return {range.lower, range.upper};
}

std::vector<const results::SectionField*> drawn_sections(const results::FillResult& result) {
  std::vector<const results::SectionField*> drawn;
  for (const auto& section : result.sections)
    if (!section.field.first.empty() && std::ranges::none_of(drawn, [&](const auto* other) {
          return same_plane(other->plane, section.plane);
        }))
      drawn.push_back(&section);
  return drawn;
}

std::vector<const results::Profile*> drawn_profiles(const results::FillResult& result) {
  std::vector<const results::Profile*> drawn;
  for (const auto& chart : profile_charts(result)) drawn.push_back(chart.profile);
  return drawn;
}

std::vector<std::filesystem::path> draw_maps(const std::filesystem::path& directory,
                                             const results::FillResult& result, const ColourRange& range,
                                             const std::string& suffix) {
  std::vector<std::filesystem::path> written;
  for (const auto& map : result.maps) {
    const auto png = directory / (map_name(map) + suffix + ".png");
    if (std::ranges::find(written, png) != written.end()) continue;
    draw_map(png, result, map, range);
    written.push_back(png);
  }
  return written;
}

std::vector<std::filesystem::path> draw_all(const std::filesystem::path& directory,
                                            const results::FillResult& result, const ColourRange& given) {
  const bool from_data = std::isnan(given.lower) && std::isnan(given.upper);
  const ColourRange range = from_data ? solid_fraction_range({&result}) : given;
  auto written = draw_maps(directory, result, range);
  const auto sections = drawn_sections(result);
  for (std::size_t n = 0; n < sections.size(); ++n) {
    std::string name = "section";
    if (n > 0) name.append("_").append(std::to_string(n + 1));
    written.push_back(directory / (name + ".png"));
    draw_section(written.back(), result, *sections[n], range);
  }
  written.push_back(directory / "snapshot.png");
  draw_snapshot(written.back(), result, range);
  const std::string subtitle = title_of(result) + ", " + subtitle_of(result);
  for (const auto& [profile, file, fill_plane] : profile_charts(result)) {
    written.push_back(directory / file);
    if (std::isfinite(fill_plane))
      draw_fill_level(written.back(), *profile, fill_plane, profile_title(*profile), subtitle);
    else
      draw_profile(written.back(), *profile, profile_title(*profile), subtitle);
  }
  return written;
}

}  // namespace diefill::render
