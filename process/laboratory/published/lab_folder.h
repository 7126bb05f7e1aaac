// The folder of the laboratory's scenes and published figures.
#pragma once

#include <filesystem>

namespace diefill::process::laboratory {

inline constexpr const char* kPublishedFigures = "published_figures.csv";  ///< in that folder

/// sample_tools/laboratory of the source tree that the program was built in, or else of the current folder.
std::filesystem::path laboratory_folder();

}  // namespace diefill::process::laboratory
