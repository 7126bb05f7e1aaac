// The small die with variants, for tests of comparisons.
#pragma once

#include "tests/app/small_die.h"

namespace diefill::app {

inline constexpr const char* kVariants = R"(
[[variant]]
name = "quick"
step.1.velocity = "0.2 m/s"

[[variant]]
name = "stays"
[[variant.step]]
kind = "wait"
duration = "1 ms"
)";

/// The small die with the two variants, and `more` below them.
inline void add_variants(const SmallDie& die, const std::string& more = "") {
  die.write("scene.toml", contents(die.scene()) + kVariants + more);
}

/// Compares without pictures of the runs.
inline std::vector<std::string> compare_arguments(const SmallDie& die,
                                                  const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {
      "compare", die.scene().string(), "--out", die.out().string(), "--jobs", "2", "--no-pictures"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

inline nlohmann::json comparison_of(const std::filesystem::path& directory) {
  return nlohmann::json::parse(contents(directory / "comparison.json"));
}

inline nlohmann::json report_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(contents(folder / "report.json"));
}

}  // namespace diefill::app
