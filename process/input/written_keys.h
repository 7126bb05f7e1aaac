// Paths of keys as changes of a scene were written (`step.1.velocity`), for messages about their values.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace diefill::process {

/// A list of a scene names its entries alike (`step.velocity`), changes name one of them. Values are found by
/// the place that they were read from, which they keep in the document that the changes are laid over.
class WrittenKeys {
 public:
  /// Takes down all keys of a document of changes (parse_changes).
  void add(const toml::table& changes);

  /// Path of the value that stands at `key` of its table; nothing where it is not of the changes.
  std::optional<std::string> path_of(const toml::node& value, const std::string& key) const;

 private:
  /// Document, line and column of a value, and its key: the tables of a dotted key begin at the same place.
  using Place = std::tuple<std::shared_ptr<const std::string>, std::uint32_t, std::uint32_t, std::string>;

  static Place place_of(const toml::node& value, const std::string& key);
  void add_below(const toml::table& table, const std::string& path);

  std::map<Place, std::string> paths_;
};

}  // namespace diefill::process
