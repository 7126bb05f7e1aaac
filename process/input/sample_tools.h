// The folder of the sample tools that come with the program: scenes, CAD files, published figures.
#pragma once

#include <filesystem>

namespace diefill::process {

/// `sample_tools` of the source tree that the program was built in or, once installed, of ../share/diefill
/// seen from the program; where there is neither, that of the current folder.
std::filesystem::path sample_tools_folder();

}  // namespace diefill::process
