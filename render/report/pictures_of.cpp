#include "render/report/pictures_of.h"

#include <QBuffer>
#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "render/density_map.h"
#include "render/report/timeline.h"
#include "render/snapshot.h"

namespace diefill::render::report {
namespace {

QByteArray png_of(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw std::runtime_error("a picture of the report could not be stored");
  return bytes;
}

QByteArray bytes_of(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly))
    throw std::runtime_error(path.string() + ": the picture cannot be read again");
  return file.readAll();
}

/// Calls `draw` with an empty folder; returns what stands in the files that it names.
std::vector<Figure> drawn(const std::function<std::vector<std::filesystem::path>(const std::string&)>& draw,
                          const std::function<std::string(const std::string&)>& caption_of) {
  const QTemporaryDir folder;
  if (!folder.isValid())
    throw std::runtime_error("no folder for temporary files can be made; is the disk full?");
  std::vector<Figure> figures;
  for (const auto& path : draw(folder.path().toStdString()))
    figures.push_back({bytes_of(path), caption_of(path.stem().string())});
  return figures;
}

std::string caption_of(const std::string& picture, bool ring) {
  if (picture == "density_map" && ring)
    return "Solid fraction over azimuth and height, mean over the ring's width.";
  if (picture == "density_map") return "Solid fraction in the plane of the first section.";
  if (picture == "section") return "Solid fraction in a plane section.";
  if (picture == "snapshot")
    return "Powder and tools at the end, cut open; grains coloured by solid fraction.";
  if (picture == "fill_level") return "Height of the powder surface above the cavity's floor.";
  std::string words = picture;
  std::replace(words.begin(), words.end(), '_', ' ');
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words + ".";
}

std::string subtitle_of(const results::FillResult& result) {
  return result.powder_name;
}

}  // namespace

std::vector<Figure> pictures_of(const results::FillResult& result) {
  const bool ring = !result.maps.empty();
  auto figures = drawn([&](const std::string& folder) { return draw_all(folder, result); },
                       [&](const std::string& picture) { return caption_of(picture, ring); });
  // Without a ring the first section is drawn as the map; once is enough.
  if (!ring && figures.size() > 1 && figures[0].png == figures[1].png) figures.erase(figures.begin());
  const ColourRange from_data{std::nan(""), std::nan("")};
  for (std::size_t n = 1; n < result.maps.size(); ++n)
    figures.push_back(field_picture(result.maps[n], result.strategy, subtitle_of(result), from_data,
                                    "Map of the " + result.maps[n].quantity + "."));
  for (std::size_t n = 1; n < result.sections.size(); ++n)
    figures.push_back(field_picture(result.sections[n].field, result.strategy, subtitle_of(result), from_data,
                                    "Section \"" + result.sections[n].plane.name + "\"."));
  for (const auto& profile : result.profiles) {
    if (profile.quantity == "fill level" || &profile == &result.profiles.front()) continue;
    const auto draw = [&](const std::string& folder) {
      const std::filesystem::path png = std::filesystem::path(folder) / "profile.png";
      draw_profile(png, profile, result.strategy, subtitle_of(result));
      return std::vector{png};
    };
    const std::string words = profile.quantity + " over " + profile.x_name + ".";
    for (auto& figure : drawn(draw, [&](const std::string&) { return words; })) {
      figure.caption.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
      figures.push_back(figure);
    }
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
  return {{png_of(compose_snapshot(bare).image), "The tools where they stood at the end, cut open."}};
}

std::vector<Figure> timeline_of(const results::FillResult& result) {
  if (result.stages.empty()) return {};
  return {{png_of(compose_timeline(result.stages)), "What the machine did, and when. Grey: no tool moved."}};
}

Figure field_picture(const results::Field2D& field, const std::string& title, const std::string& subtitle,
                     const ColourRange& range, const std::string& caption) {
  return {png_of(compose_field(field, title, subtitle, range).image), caption};
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
