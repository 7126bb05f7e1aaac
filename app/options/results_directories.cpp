#include "app/options/results_directories.h"

#include <map>
#include <string>
#include <system_error>

#include "process/input/scene_error.h"

namespace diefill::app {

void require_distinct(const std::string& what, const std::vector<std::filesystem::path>& directories) {
  std::map<std::filesystem::path, std::filesystem::path> known;
  for (const auto& directory : directories) {
    std::error_code none;
    auto place = std::filesystem::canonical(directory, none);
    if (none) continue;  // reading it says what is wrong
    const auto [first, is_new] = known.emplace(std::move(place), directory);
    if (!is_new)
      throw process::SceneError(what + ": found \"" + directory.string() + "\" and \"" +
                                first->second.string() +
                                "\", which are the same results; give each run once");
  }
}

}  // namespace diefill::app
