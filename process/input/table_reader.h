// Reads one table of a scene file: typed values with unit, range and default, and messages with file, line,
// key, what was found and what is allowed. Rejects all keys that were not requested.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "process/input/units.h"
#include "process/input/written_keys.h"

namespace diefill::process {

/// What a key with a unit accepts. Limits are written as a user would, such as "10 m/s"; empty: no limit.
struct QuantityRule {
  Dimension dimension = Dimension::length;
  std::string_view example;
  std::string_view least, most;
  bool above = false;  ///< `least` itself is not allowed
};

/// What a key with a bare number accepts.
struct NumberRule {
  double least = 0, most = 0;
  bool above = false;  ///< `least` itself is not allowed
  std::string_view example;
};

/// Words of a choice and their values.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// One table. Getters return nothing when the key is absent and throw SceneError when its value is not what
/// the rule allows; the `required_` ones also throw when it is absent. Lives no longer than the document it
/// reads.
class TableReader {
 public:
  /// `path` names the table in messages, such as "powder"; empty for the document itself. Values that are of
  /// changes (`written`, which outlives the reader) are named as the changes name them.
  TableReader(const toml::table& table, std::filesystem::path file, std::string path,
              const WrittenKeys* written = nullptr);

  const std::filesystem::path& file() const { return file_; }
  const std::string& path() const { return path_; }
  /// Line of the table's header in the file, from 1.
  int line() const;

  bool has(const std::string& key);
  /// Whether it is there and a list.
  bool has_list(const std::string& key);

  std::optional<double> quantity(const std::string& key, const QuantityRule& rule);
  double required_quantity(const std::string& key, const QuantityRule& rule);
  std::optional<double> number(const std::string& key, const NumberRule& rule);
  std::optional<std::int64_t> integer(const std::string& key, std::int64_t least, std::int64_t most);
  std::optional<bool> flag(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::string required_text(const std::string& key, const std::string& example);
  /// A text fit for a name: not empty, no slash, no control characters.
  std::string required_name(const std::string& key, const std::string& example);

  /// A list of one or more texts, or a single text; empty when the key is absent.
  std::vector<std::string> texts(const std::string& key, const std::string& example);
  /// A list of one or more quantities; empty when the key is absent.
  std::vector<double> quantities(const std::string& key, const QuantityRule& rule);

  /// Three quantities along x, y, z.
  std::optional<Eigen::Vector3d> point(const std::string& key, const QuantityRule& rule);
  Eigen::Vector3d required_point(const std::string& key, const QuantityRule& rule);
  /// A unit vector from "x", "y", "z" (with or without sign) or three numbers that have a direction
  /// (unit_vector.h).
  std::optional<Eigen::Vector3d> direction(const std::string& key);

  template <class Value>
  std::optional<Value> choice(const std::string& key, const Choices<Value>& choices) {
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) words.push_back(word);
    const auto index = chosen(key, words);
    if (!index) return std::nullopt;
    return choices[*index].second;
  }
  template <class Value>
  Value required_choice(const std::string& key, const Choices<Value>& choices) {
    require(key, '"' + choices.front().first + '"');
    return *choice(key, choices);
  }

  /// A table, as [key] or { ... }.
  std::optional<TableReader> table(const std::string& key);
  TableReader required_table(const std::string& key);
  /// All tables of a [[key]] list; empty when there is none.
  std::vector<TableReader> tables(const std::string& key);

  /// Throws SceneError for the first key that was not requested, with the nearest one that exists.
  void finish() const;

  /// Throws SceneError that `key` is missing, unless it is there.
  void require(const std::string& key, const std::string& example);
  /// "file:line:column: table.key", the place of the key's value, or of the table when the key is absent.
  std::string where(const std::string& key) const;
  /// Throws SceneError at `key`: "<where>: found <value>, <allowed>".
  [[noreturn]] void reject(const std::string& key, const std::string& allowed) const;

 private:
  const toml::node* find(const std::string& key);
  double checked_quantity(const toml::node& node, const std::string& key, const QuantityRule& rule) const;
  std::optional<std::size_t> chosen(const std::string& key, const std::vector<std::string>& words);
  std::string full_key(const std::string& key) const;
  std::string named(const toml::source_region& at, const std::string& key) const;
  [[noreturn]] void reject_node(const toml::node& node, const std::string& key,
                                const std::string& allowed) const;

  const toml::table* table_;
  std::filesystem::path file_;
  std::string path_;
  const WrittenKeys* written_;
  std::vector<std::string> known_;
};

}  // namespace diefill::process
