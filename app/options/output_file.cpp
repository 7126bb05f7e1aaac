#include "app/options/output_file.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "app/output.h"
#include "process/input/scene_error.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

fs::path directory_of(const fs::path& file) {
  const fs::path parent = file.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

bool is_input(const fs::path& file, const std::vector<fs::path>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& input) {
    std::error_code none;  // of files that are not there
    return fs::equivalent(file, input, none);
  });
}

}  // namespace

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

void require_output_file(const OutputFile& output, const std::vector<fs::path>& inputs) {
  const std::string found = output.option + ": found \"" + output.file.string() + "\"";
  const auto& endings = output.endings;
  if (std::find(endings.begin(), endings.end(), ending_of(output.file)) == endings.end()) {
    std::string allowed;
    for (const auto& ending : endings) allowed += (allowed.empty() ? "" : " or ") + ending;
    throw process::SceneError(found + ", allowed: a file that ends in " + allowed + "; nothing was written");
  }
  std::error_code error;
  const auto status = fs::status(output.file, error);
  if (error == std::errc::filename_too_long)
    throw process::SceneError(found + ", whose name is too long; choose a shorter one");
  if (fs::is_directory(status))
    throw process::SceneError(found + ", which is a directory; name a file in it");
  if (is_input(output.file, inputs))
    throw process::SceneError(found + ", which the command reads; choose another file");
  require_directory(directory_of(output.file), output.option);
  require_writable(directory_of(output.file), output.option);
}

void require_other_files(const std::string& option, const fs::path& directory,
                         const std::vector<std::string>& names, const std::vector<fs::path>& inputs) {
  for (const auto& name : names) {
    const std::string found = option + ": found \"" + directory.string() + "\", whose " + name;
    if (is_input(directory / name, inputs))
      throw process::SceneError(found + " the command reads and would overwrite; choose another directory");
    std::error_code none;
    if (fs::is_directory(directory / name, none))
      throw process::SceneError(found +
                                " is a directory, where the command writes a file; rename it, or choose "
                                "another directory");
  }
}

void make_directory_of(const OutputFile& output) {
  make_output_directory(directory_of(output.file), output.option);
}

}  // namespace diefill::app
