#include "tests/project/source_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "project_paths.h"

namespace diefill::project {

namespace {

constexpr std::array<const char*, 7> kFolders = {"engine", "geometry", "process",     "render",
                                                 "app",    "tests",    "sample_tools"};

std::vector<std::string> files_with(const std::vector<std::string>& endings) {
  const std::filesystem::path root = DIEFILL_SOURCE_DIR;
  std::vector<std::string> files;
  const auto take = [&](const std::filesystem::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    const bool wanted =
        std::any_of(endings.begin(), endings.end(), [&](const auto& end) { return name.ends_with(end); });
    if (entry.is_regular_file() && wanted)
      files.push_back(std::filesystem::relative(entry.path(), root).string());
  };
  for (const auto& entry : std::filesystem::directory_iterator(root)) take(entry);
  for (const char* folder : kFolders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) take(entry);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> source_files() {
  return files_with({".h", ".cpp", ".c"});
}

std::vector<std::string> written_files() {
  return files_with(
      {".h", ".cpp", ".c", ".txt", ".cmake", ".md", ".sh", ".toml", ".scad", ".json", ".cff", ".py"});
}

std::string text_of(const std::string& file) {
  std::ifstream stream(std::filesystem::path(DIEFILL_SOURCE_DIR) / file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool exists_beside(const std::string& file, const std::string& link) {
  return std::filesystem::exists((std::filesystem::path(DIEFILL_SOURCE_DIR) / file).parent_path() / link);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string in_lines(const std::vector<std::string>& items) {
  std::string text;
  for (const auto& item : items) text += item + "\n";
  return text;
}

}  // namespace diefill::project
