// The folder of the sample tools that come with the program: scenes, CAD files, published figures.
#pragma once

#include <filesystem>

namespace diefill::process {

/// The sample tools of a program in the folder `program`: installed in ../share/diefill, or those of the
/// source tree whose build it belongs to; where there is neither, `sample_tools` of the current folder.
std::filesystem::path sample_tools_beside(const std::filesystem::path& program);

/// The same of the program that runs.
std::filesystem::path sample_tools_folder();

/// Whether `sample_tools` is that of a source tree: a CMakeLists.txt stands beside it.
bool in_source_tree(const std::filesystem::path& sample_tools);

}  // namespace diefill::process
