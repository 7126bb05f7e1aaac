// The pictures of one filling, from results alone: density map, plane sections, shaded view.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::render {

/// Range of a colour scale; both NaN: from the data.
struct ColourRange {
  double lower, upper;
};
inline constexpr ColourRange kRangeFromData{std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN()};

/// Draws a field over (azimuth, height) or any two coordinates as a PNG: axes with units, colour bar, title
/// of strategy and grain size, perceptually even colours, holes (NaN) in neutral grey.
void draw_field(const std::filesystem::path& png, const results::Field2D& field, const std::string& title,
                const std::string& subtitle, const ColourRange& range);

/// A shaded view of powder (coloured by solid fraction where closed, on the scale `range`) and cut-away tools
/// as a PNG with colour bar.
void draw_snapshot(const std::filesystem::path& png, const results::FillResult& result,
                   const ColourRange& range = kRangeFromData);

/// Curves with axes and units as a PNG.
void draw_profile(const std::filesystem::path& png, const results::Profile& profile, const std::string& title,
                  const std::string& subtitle);

/// A fill level [mm] as a PNG, with the fill plane `depth` [mm] above the cavity's floor.
void draw_fill_level(const std::filesystem::path& png, const results::Profile& level, double depth,
                     const std::string& title, const std::string& subtitle);

/// One scale for all that is drawn of the solid fraction of these results, so that a colour means the same on
/// every picture: from their maps and sections.
ColourRange solid_fraction_range(const std::vector<const results::FillResult*>& results);

/// The sections that have a picture: those that go through powder, each plane once.
std::vector<const results::SectionField*> drawn_sections(const results::FillResult& result);

/// The profiles that draw_all() draws: the fill level of each cavity, and of those that are no rings the
/// solid fraction over height; the first profile where there is none of these.
std::vector<const results::Profile*> drawn_profiles(const results::FillResult& result);

/// Writes into `directory` the maps of the result's cavity: density_map.png over azimuth and height of a
/// ring; plan_map.png (x and y, mean over the height of the powder) and fill_level_map.png of any other.
/// `suffix` follows the names before ".png". Returns what was written.
std::vector<std::filesystem::path> draw_maps(const std::filesystem::path& directory,
                                             const results::FillResult& result, const ColourRange& range,
                                             const std::string& suffix = "");

/// Writes the maps, section.png (section_2.png and so on where there are more), snapshot.png, and
/// fill_level.png and, where the cavity is no ring, height_profile.png (of further cavities with
/// `_cavity_2` and so on after the name), into `directory`; returns what was
/// written. `range` is that of the solid fraction; from the result where it is kRangeFromData.
std::vector<std::filesystem::path> draw_all(const std::filesystem::path& directory,
                                            const results::FillResult& result,
                                            const ColourRange& range = kRangeFromData);

}  // namespace diefill::render
