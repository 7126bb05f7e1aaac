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

void require_no_copies(const std::string& what, const std::vector<ReadDirectory>& directories) {
  for (std::size_t later = 1; later < directories.size(); ++later)
    for (std::size_t k = 0; k < later; ++k) {
      const results::FillResult &one = *directories[k].result, &other = *directories[later].result;
      if (one.state_hash.empty() || one.state_hash != other.state_hash || one.seed != other.seed ||
          one.scene_text != other.scene_text)
        continue;
      throw process::SceneError(what + ": found \"" + directories[later].directory.string() +
                                "\" with a copy of the results in \"" + directories[k].directory.string() +
                                "\" (seed " + std::to_string(one.seed) +
                                ", same final state); give each run once");
    }
}

}  // namespace diefill::app
