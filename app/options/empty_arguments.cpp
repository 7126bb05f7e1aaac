#include "app/options/empty_arguments.h"

namespace diefill::app {
namespace {

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// The option, without its value, before word `n`; empty where an argument without name comes first.
std::string option_before(const std::vector<std::string>& words, std::size_t n) {
  while (n > 0) {
    const std::string& word = words[--n];
    if (word == "--") return {};
    if (word.starts_with("--")) return word.find('=') == std::string::npos ? word : std::string();
  }
  return {};
}

}  // namespace

std::optional<std::string> empty_argument(const std::vector<std::string>& words) {
  for (std::size_t n = 0; n < words.size(); ++n) {
    const std::string& word = words[n];
    const std::size_t equals = word.find('=');
    if (word.starts_with("--") && equals != std::string::npos && is_blank(word.substr(equals + 1)))
      return word.substr(0, equals) + ": no value after =; give a value or leave the option out";
    if (!is_blank(word)) continue;
    const std::string option = option_before(words, n);
    if (option.empty())
      return "argument " + std::to_string(n + 1) + ": found an empty text; give a value or leave it out";
    return option + ": found an empty text; give a value or leave the option out";
  }
  return std::nullopt;
}

}  // namespace diefill::app
