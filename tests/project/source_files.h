// The project's own files, read as text, for tests of its rules.
#pragma once

#include <string>
#include <vector>

namespace diefill::project {

/// Paths from the project's folder, sorted, of all C++ files.
std::vector<std::string> source_files();
/// The same of all files that people write: sources, CMake, documents, scripts, scenes.
std::vector<std::string> written_files();

std::string text_of(const std::string& file);
/// Whether `link` leads to a file or folder, counted from the folder of `file`.
bool exists_beside(const std::string& file, const std::string& link);
/// Lines without their ends.
std::vector<std::string> lines_of(const std::string& text);
/// One below the other, to be shown.
std::string in_lines(const std::vector<std::string>& items);

}  // namespace diefill::project
