#include "render/pictures.h"

#include <QString>
#include <limits>

#include "render/density_map.h"
#include "render/picture_file.h"
#include "render/ticks.h"
#include "render/tool_outline.h"

namespace diefill::render {
namespace {

constexpr double kFromData = std::numeric_limits<double>::quiet_NaN();

std::string subtitle_of(const results::FillResult& result) {
  std::string text = result.powder_name;
  if (result.powder.grain_diameter > 0) {
    text += (text.empty() ? "" : ", ") + ("grain size " + result.powder.sizes_in_words());
  }
  return text;
}

// Map and sections of one result share a scale, so that a colour means the same on both.
ColourRange common_range(const results::FillResult& result) {
  std::vector<double> values;
  for (const auto& map : result.maps) values.insert(values.end(), map.value.begin(), map.value.end());
  for (const auto& section : result.sections)
    values.insert(values.end(), section.field.value.begin(), section.field.value.end());
  if (values.empty()) return {kFromData, kFromData};
  const Interval range = robust_range(values);
  return {range.lower, range.upper};
}

const results::Profile* fill_level_of(const results::FillResult& result) {
  for (const auto& profile : result.profiles)
    if (profile.quantity == "fill level") return &profile;
  return result.profiles.empty() ? nullptr : &result.profiles.front();
}

/// The first that goes through powder; nothing where none does.
const results::SectionField* section_to_draw(const results::FillResult& result) {
  for (const auto& section : result.sections)
    if (!section.field.first.empty()) return &section;
  return nullptr;
}

}  // namespace

std::vector<std::filesystem::path> draw_all(const std::filesystem::path& directory,
                                            const results::FillResult& result) {
  std::vector<std::filesystem::path> written;
  const std::string title = result.strategy.empty() ? result.title : result.strategy;
  const std::string subtitle = subtitle_of(result);
  const ColourRange range = common_range(result);
  const auto field_picture = [&](const char* name, const results::Field2D& field,
                                 const std::vector<Outline>& outlines) {
    FieldStyle style;
    style.mark_mean = true;
    style.outlines = outlines;
    write_png(directory / name, compose_field(field, title, subtitle, range, style).image);
    written.push_back(directory / name);
  };
  const results::SectionField* section = section_to_draw(result);
  const auto section_picture = [&](const char* name) {
    field_picture(name, section->field, tool_outlines(result.tools, section->plane));
  };
  if (!result.maps.empty()) {
    const auto& map = result.maps.front();
    field_picture("density_map.png", map, fill_plane_outline(result.cavity, map));
  } else if (section != nullptr) {
    section_picture("density_map.png");
  }
  if (section != nullptr) section_picture("section.png");
  draw_snapshot(directory / "snapshot.png", result);
  written.push_back(directory / "snapshot.png");
  if (const auto* profile = fill_level_of(result)) {
    draw_profile(directory / "fill_level.png", *profile, title, subtitle);
    written.push_back(directory / "fill_level.png");
  }
  return written;
}

}  // namespace diefill::render
