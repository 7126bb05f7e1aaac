#include "render/report/pictures_of.h"

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>

#include "process/results/figure_table.h"
#include "render/fields/density_map.h"
#include "render/fields/difference_map.h"
#include "render/fields/field_places.h"
#include "render/report/sections/timeline.h"
#include "render/scene3d/snapshot.h"
#include "render/style/picture_bytes.h"

namespace diefill::render::report {
namespace {

QByteArray bytes_of(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error(path.string() + ": cannot read the picture");
  return file.readAll();
}

/// Calls `draw` with an empty folder; returns what stands in the files that it names.
std::vector<Figure> drawn(const std::function<std::vector<std::filesystem::path>(const std::string&)>& draw,
                          const std::function<std::string(const std::string&)>& caption_of) {
  const QTemporaryDir folder;
  if (!folder.isValid())
    throw std::runtime_error("cannot create a folder for temporary files; is the disk full?");
  std::vector<Figure> figures;
  for (const auto& path : draw(folder.path().toStdString()))
    figures.push_back({bytes_of(path), caption_of(path.stem().string())});
  return figures;
}

/// "_2" -> 2; none: 1.
std::size_t number_in(const std::string& picture) {
  const auto at = picture.find_last_of('_');
  return at == std::string::npos ? 1 : std::stoul(picture.substr(at + 1));
}

/// ", cavity 2" of "fill_level_cavity_2".
std::string of_cavity(const std::string& picture) {
  const auto at = picture.find("_cavity_");
  return at == std::string::npos ? "" : ", cavity " + std::to_string(number_in(picture));
}

std::string caption_of(const std::string& picture, const results::FillResult& result) {
  if (picture == "density_map") return "Solid fraction over azimuth and height, mean over the ring's width.";
  if (picture == "plan_map") return "Solid fraction seen from above, mean over the height of the powder.";
  if (picture == "fill_level_map")
    return "Height of the powder surface above the cavity floor, seen from above.";
  if (picture.starts_with("section")) {
    const auto* section = drawn_sections(result).at(number_in(picture) - 1);
    return "Solid fraction, " + section_text(section->plane) + ".";
  }
  if (picture == "snapshot")
    return "Powder and tools at the end, cut open; grains coloured by solid fraction.";
  if (picture.starts_with("fill_level"))
    return "Height of the powder surface above the cavity's floor" + of_cavity(picture) + ".";
  if (picture.starts_with("height_profile")) return "Solid fraction over height" + of_cavity(picture) + ".";
  std::string words = picture;
  std::replace(words.begin(), words.end(), '_', ' ');
  return results::capitalised(words) + ".";
}

/// The maps of a further cavity, which its title names.
void add_cavity_maps(std::vector<Figure>& figures, const results::FillResult& cavity, std::size_t number,
                     const ColourRange& range) {
  const auto draw = [&](const std::string& folder) { return draw_maps(folder, cavity, range); };
  for (auto& figure : drawn(draw, [&](const std::string& picture) { return caption_of(picture, cavity); })) {
    figure.caption = "Cavity " + std::to_string(number) + ". " + figure.caption;
    figures.push_back(std::move(figure));
  }
}

std::string subtitle_of(const results::FillResult& result) {
  return result.powder_name;
}

}  // namespace

std::vector<Figure> pictures_of(const results::FillResult& result, const SharedPictures& shared) {
  const bool from_data = std::isnan(shared.range.lower) && std::isnan(shared.range.upper);
  const ColourRange range = from_data ? solid_fraction_range({&result}) : shared.range;
  auto figures = drawn([&](const std::string& folder) { return draw_all(folder, result, range); },
                       [&](const std::string& picture) { return caption_of(picture, result); });
  if (shared.other_cavities != nullptr)
    for (std::size_t n = 0; n < shared.other_cavities->size(); ++n)
      add_cavity_maps(figures, (*shared.other_cavities)[n], n + 2, range);
  const auto there = drawn_profiles(result);
  for (const auto& profile : result.profiles) {
    if (std::ranges::find(there, &profile) != there.end()) continue;
    const auto draw = [&](const std::string& folder) {
      const std::filesystem::path png = std::filesystem::path(folder) / "profile.png";
      draw_profile(png, profile, results::capitalised(profile.quantity + " over " + profile.x_name),
                   result.strategy + ", " + subtitle_of(result));
      return std::vector{png};
    };
    const std::string words = results::capitalised(profile.quantity + " over " + profile.x_name + ".");
    for (auto& figure : drawn(draw, [&](const std::string&) { return words; })) figures.push_back(figure);
  }
  return figures;
}

std::vector<Figure> tool_views(const results::FillResult& result) {
  if (result.tools.empty()) return {};
  results::FillResult bare = result;
  bare.powder.id.clear();
  bare.powder.position.clear();
  bare.powder.orientation.clear();
  bare.powder.velocity.clear();
  bare.powder.angular_velocity.clear();
  bare.solid_fraction = {};
  return {{png_bytes(compose_snapshot(bare).image), "The tools at the end of the run, cut open."}};
}

std::vector<Figure> timeline_of(const results::FillResult& result) {
  if (result.stages.empty()) return {};
  return {{png_bytes(compose_timeline(result.stages)), "Schedule of the machine. Grey: no tool moved."}};
}

Figure field_picture(const results::Field2D& field, const std::string& title, const std::string& subtitle,
                     const ColourRange& range, const std::string& caption, const FieldStyle& style) {
  return {png_bytes(compose_field(field, title, subtitle, range, style).image), caption};
}

Figure difference_picture(const results::Field2D& difference, const std::string& title,
                          const std::string& subtitle, const std::string& caption, const FieldStyle& style) {
  const double from_data = std::numeric_limits<double>::quiet_NaN();
  return {png_bytes(compose_difference(difference, title, subtitle, from_data, style).image), caption};
}

Figure chart_picture(const Chart& chart, const std::string& caption) {
  const auto draw = [&](const std::string& folder) {
    const std::filesystem::path png = std::filesystem::path(folder) / "chart.png";
    draw_chart(png, chart);
    return std::vector{png};
  };
  return drawn(draw, [&](const std::string&) { return caption; }).front();
}

}  // namespace diefill::render::report
