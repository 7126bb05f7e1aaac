#include "process/input/written_keys.h"

#include <toml++/toml.h>

namespace diefill::process {
namespace {

/// Quotes a word that TOML takes as part of a key only in quotes.
std::string quoted_if_needed(const std::string& word) {
  constexpr const char* kBare = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  const bool bare = !word.empty() && word.find_first_not_of(kBare) == std::string::npos;
  return bare ? word : '"' + word + '"';
}

}  // namespace

WrittenKeys::Place WrittenKeys::place_of(const toml::node& value, const std::string& key) {
  const toml::source_region& region = value.source();
  return {region.path, region.begin.line, region.begin.column, key};
}

void WrittenKeys::add(const toml::table& changes) {
  add_below(changes, "");
}

void WrittenKeys::add_below(const toml::table& table, const std::string& path) {
  for (const auto& [key, value] : table) {
    const std::string word(key.str());
    const std::string written = path + (path.empty() ? "" : ".") + quoted_if_needed(word);
    paths_.insert_or_assign(place_of(value, word), written);
    if (const toml::table* below = value.as_table()) add_below(*below, written);
  }
}

std::optional<std::string> WrittenKeys::path_of(const toml::node& value, const std::string& key) const {
  const auto found = paths_.find(place_of(value, key));
  if (found == paths_.end()) return std::nullopt;
  return found->second;
}

}  // namespace diefill::process
