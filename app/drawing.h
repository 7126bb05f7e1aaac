// Draws the pictures of a result, with the drawing set up on first use.
#pragma once

#include <filesystem>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::app {

/// Sets up drawing without a screen; may be called again.
void start_drawing();

/// Writes the standard pictures of `result` into `directory`; returns their paths.
std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result);

}  // namespace diefill::app
