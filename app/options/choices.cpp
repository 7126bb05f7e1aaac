#include "app/options/choices.h"

#include <algorithm>

#include "process/input/nearest_key.h"

namespace diefill::app {

std::string unknown_name(const std::string& found, const std::vector<std::string>& names) {
  std::string text = "found \"" + found + "\"";
  if (const auto nearest = process::nearest_key(found, names)) text += "; did you mean \"" + *nearest + "\"?";
  return text + " (allowed: " + CLI::detail::join(names, ", ") + ")";
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](std::string& text) {
        const bool known = std::find(names.begin(), names.end(), text) != names.end();
        return known ? std::string() : unknown_name(text, names);
      },
      "{" + CLI::detail::join(names, ",") + "}");
}

}  // namespace diefill::app
