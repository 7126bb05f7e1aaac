// The folder of the laboratory's scenes and published figures.
#pragma once

#include <filesystem>

namespace diefill::process::laboratory {

inline constexpr const char* kPublishedFigures = "published_figures.csv";  ///< in that folder

/// `laboratory` in the folder of the sample tools (process/input/sample_tools.h).
std::filesystem::path laboratory_folder();

}  // namespace diefill::process::laboratory
