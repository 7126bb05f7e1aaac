// The pictures of one filling, from results alone: density map, plane sections, shaded view.
#pragma once

#include <filesystem>

#include "process/results/fill_result.h"

namespace diefill::render {

/// Sets up drawing without a screen. Call once, before any picture; `argc` and `argv` go to Qt.
/// Throws std::runtime_error when no software renderer is available.
void start_offscreen(int& argc, char** argv);

/// Range of a colour scale; both NaN: from the data.
struct ColourRange {
  double lower, upper;
};

/// Draws a field over (azimuth, height) or any two coordinates as a PNG: axes with units, colour bar, title
/// of strategy and grain size, perceptually even colours, holes (NaN) in neutral grey.
void draw_field(const std::filesystem::path& png, const results::Field2D& field, const std::string& title,
                const std::string& subtitle, const ColourRange& range);

/// A shaded view of powder (coloured by solid fraction where closed) and cut-away tools as a PNG with colour
/// bar.
void draw_snapshot(const std::filesystem::path& png, const results::FillResult& result);

/// Curves with axes and units as a PNG.
void draw_profile(const std::filesystem::path& png, const results::Profile& profile, const std::string& title,
                  const std::string& subtitle);

/// Writes density_map.png (or the section again where the cavity is no ring), section.png (the first that
/// goes through powder; none where none does), snapshot.png and fill_level.png into `directory`; returns what
/// was written.
std::vector<std::filesystem::path> draw_all(const std::filesystem::path& directory,
                                            const results::FillResult& result);

}  // namespace diefill::render
