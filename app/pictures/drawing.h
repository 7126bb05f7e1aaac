// Draws the pictures of a result, with the drawing set up on first use.
#pragma once

#include <filesystem>
#include <vector>

#include "process/results/fill_result.h"
#include "process/results/studies/comparison.h"
#include "render/fields/pictures.h"

namespace diefill::app {

/// Sets drawing up, unless that has been done. Throws std::runtime_error where there is no renderer.
void set_up_drawing();

/// `result` as of each of its further cavities, in their order: maps measured with the Gaussian width of its
/// own fields, titles that name the cavity, and neither instants nor probes.
std::vector<results::FillResult> of_other_cavities(const results::FillResult& result);

/// The colour scale of the solid fraction that all pictures of these results share: that of the maps and
/// sections of all their cavities.
render::ColourRange range_of_all_cavities(const std::vector<const results::FillResult*>& results);

/// Writes the standard pictures of `result` into `directory`, and the maps of its further cavities with
/// "_cavity_2" and so on after their names; returns their paths.
std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result);

/// Writes comparison.png into `directory`, where a variant has a field to draw; returns what was written.
std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::Comparison& comparison);

}  // namespace diefill::app
