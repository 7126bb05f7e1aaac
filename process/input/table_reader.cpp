#include "process/input/table_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "process/input/allowed_range.h"
#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/source_place.h"
#include "process/input/unit_vector.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

/// Lists longer than in any scene would take minutes to process.
constexpr std::size_t kMaxEntries = 1000, kLongestName = 100;
constexpr std::size_t kLongestKey = 120;  // characters of a path in a message
/// Names that a message lists before it says how many more there are.
constexpr std::size_t kMaxListed = 20;

void refuse_long(const toml::array& list, const std::string& where) {
  if (list.size() <= kMaxEntries) return;
  throw SceneError(where + ": found a list of " + std::to_string(list.size()) + ", allowed: up to " +
                   std::to_string(kMaxEntries));
}

std::string listed(std::vector<std::string> words) {
  for (std::string& word : words) word = '"' + one_line(word) + '"';
  return results::comma_list(words, kMaxListed, " or ");
}

constexpr std::string_view kAxes = "xyz";

/// The value of a whole or decimal number. Whole numbers beyond 2^53 lose digits that no range here allows
/// anyway.
double plain_number(const toml::node& node) {
  if (const auto whole = node.value_exact<std::int64_t>()) return static_cast<double>(*whole);
  return *node.value_exact<double>();
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::filesystem::path file, std::string path,
                         const WrittenKeys* written)
    : table_(&table), file_(std::move(file)), path_(std::move(path)), written_(written) {}

int TableReader::line() const {
  return std::max(1, static_cast<int>(table_->source().begin.line));
}

std::string TableReader::full_key(const std::string& key) const {
  const std::string shown = key.empty() ? "\"\"" : key;
  return one_line(path_.empty() ? shown : path_ + '.' + shown, kLongestKey);
}

/// Place and path of the value at `key`, which may name a part of it, such as "position[x]".
std::string TableReader::named(const toml::source_region& at, const std::string& key) const {
  const std::size_t part = key.ends_with(']') ? key.rfind('[') : key.size();
  const std::string whole = key.substr(0, part);
  const toml::node* value = table_->get(whole);
  const auto written =
      written_ != nullptr && value != nullptr ? written_->path_of(*value, whole) : std::nullopt;
  return source_place(file_, at) + ": " +
         (written ? one_line(*written + key.substr(part), kLongestKey) : full_key(key));
}

const toml::node* TableReader::find(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_->get(key);
}

bool TableReader::has(const std::string& key) {
  return find(key) != nullptr;
}

std::string TableReader::where(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return named((node != nullptr ? node : table_)->source(), key);
}

void TableReader::reject_node(const toml::node& node, const std::string& key,
                              const std::string& allowed) const {
  throw SceneError(named(node.source(), key) + ": found " + shown_value(node) + ", " + allowed);
}

void TableReader::reject(const std::string& key, const std::string& allowed) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) throw SceneError(where(key) + ": " + allowed);
  reject_node(*node, key, allowed);
}

void TableReader::require(const std::string& key, const std::string& example) {
  if (has(key)) return;
  std::optional<std::string> meant;  // of the keys that are there
  for (const auto& [name, value] : *table_) {
    const std::string present(name.str());
    if (std::find(known_.begin(), known_.end(), present) != known_.end()) continue;
    if (!nearest_key(present, {key})) continue;
    if (!meant || edit_distance(present, key) < edit_distance(*meant, key)) meant = present;
  }
  throw SceneError(where(key) + ": found nothing, a value is required, such as " + example +
                   (meant ? " (found \"" + *meant + "\": did you mean \"" + key + "\"?)" : ""));
}

double TableReader::checked_quantity(const toml::node& node, const std::string& key,
                                     const QuantityRule& rule) const {
  const std::string_view example = rule.example.empty() ? example_of(rule.dimension) : rule.example;
  const auto text = node.value_exact<std::string>();
  if (!text)
    reject_node(node, key,
                "expected " + description(rule.dimension) + " with its unit, such as \"" +
                    std::string(example) + '"');
  double value = 0;
  try {
    value = parse_quantity(*text, rule.dimension, example);
  } catch (const UnitError& error) {
    reject_node(node, key, error.what());
  }
  const double least = rule.least.empty() ? -HUGE_VAL : parse_quantity(rule.least, rule.dimension);
  const double most = rule.most.empty() ? HUGE_VAL : parse_quantity(rule.most, rule.dimension);
  if (!within(value, least, rule.above, most)) {
    reject_node(
        node, key,
        allowed_range(rule.least, rule.above, rule.most) + ", such as \"" + std::string(example) + '"');
  }
  return value;
}

std::optional<double> TableReader::quantity(const std::string& key, const QuantityRule& rule) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return checked_quantity(*node, key, rule);
}

double TableReader::required_quantity(const std::string& key, const QuantityRule& rule) {
  require(key, '"' + std::string(rule.example.empty() ? example_of(rule.dimension) : rule.example) + '"');
  return *quantity(key, rule);
}

std::optional<double> TableReader::number(const std::string& key, const NumberRule& rule) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const std::string example = "such as " + std::string(rule.example);
  if (!node->is_number()) reject_node(*node, key, "expected a number without quotes or unit, " + example);
  const double value = plain_number(*node);
  if (!within(value, rule.least, rule.above, rule.most)) {
    reject_node(*node, key,
                allowed_range(number_text(rule.least), rule.above, number_text(rule.most)) + ", " + example);
  }
  return value;
}

std::optional<std::int64_t> TableReader::integer(const std::string& key, std::int64_t least,
                                                 std::int64_t most) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value_exact<std::int64_t>();
  if (!value || *value < least || *value > most) {
    reject_node(*node, key,
                "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

std::optional<bool> TableReader::flag(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value_exact<bool>();
  if (!value) reject_node(*node, key, "expected true or false without quotes");
  return value;
}

std::optional<std::string> TableReader::text(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  auto value = node->value_exact<std::string>();
  if (!value) reject_node(*node, key, "expected a text in quotes");
  if (!is_printable(*value))
    reject_node(*node, key, "expected a text on one line, without line breaks or other control characters");
  return value;
}

std::string TableReader::required_text(const std::string& key, const std::string& example) {
  require(key, '"' + example + '"');
  return *text(key);
}

std::string TableReader::required_name(const std::string& key, const std::string& example) {
  std::string name = required_text(key, example);
  if (name.empty() || name.find('/') != std::string::npos) {
    reject(key, "expected a name of at least one letter and no slash, such as \"" + example + '"');
  }
  if (name.size() > kLongestName)
    reject(key, "the name has " + std::to_string(name.size()) + " bytes, allowed: up to " +
                    std::to_string(kLongestName) + ", because files and columns are named after it");
  return name;
}

std::vector<std::string> TableReader::texts(const std::string& key, const std::string& example) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (const auto single = node->value_exact<std::string>()) return {*single};
  const std::string needed = "expected a text or a list of texts, such as [\"" + example + "\"]";
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) reject_node(*node, key, needed);
  refuse_long(*list, where(key));
  std::vector<std::string> values;
  for (const toml::node& element : *list) {
    const auto text = element.value_exact<std::string>();
    if (!text) reject_node(element, key, needed);
    values.push_back(*text);
  }
  return values;
}

std::vector<double> TableReader::quantities(const std::string& key, const QuantityRule& rule) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty())
    reject_node(*node, key, "expected a list, such as [\"" + std::string(rule.example) + "\"]");
  refuse_long(*list, where(key));
  std::vector<double> values;
  for (const toml::node& element : *list) values.push_back(checked_quantity(element, key, rule));
  return values;
}

bool TableReader::has_list(const std::string& key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_array();
}

std::optional<Eigen::Vector3d> TableReader::point(const std::string& key, const QuantityRule& rule) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  const std::string example(rule.example.empty() ? example_of(rule.dimension) : rule.example);
  if (list == nullptr || list->size() != 3) {
    reject_node(*node, key,
                "expected three values along x, y and z, such as [\"" + example + "\", \"0 mm\", \"0 mm\"]");
  }
  Eigen::Vector3d values;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values[static_cast<Eigen::Index>(axis)] =
        checked_quantity((*list)[axis], key + '[' + kAxes[axis] + ']', rule);
  }
  return values;
}

Eigen::Vector3d TableReader::required_point(const std::string& key, const QuantityRule& rule) {
  require(key, "[\"" + std::string(rule.example) + "\", \"0 mm\", \"0 mm\"]");
  return *point(key, rule);
}

std::optional<Eigen::Vector3d> TableReader::direction(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const std::string needed =
      "expected an axis (\"x\", \"y\", \"z\", \"-x\", ...) or three numbers that are not all zero, such as "
      "[0, 1, 0]";
  if (const auto word = node->value_exact<std::string>()) {
    const auto axis = axis_called(*word);
    if (!axis) reject_node(*node, key, needed);
    return axis;
  }
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != 3) reject_node(*node, key, needed);
  Eigen::Vector3d vector;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(*list)[axis].is_number()) reject_node(*node, key, needed);
    vector[static_cast<Eigen::Index>(axis)] = plain_number((*list)[axis]);
  }
  if (!vector.allFinite() || vector.isZero(0)) reject_node(*node, key, needed);
  const auto direction = unit_vector(vector);
  if (!direction)
    reject_node(*node, key,
                "the largest number must lie between " + number_text(kShortestDirection) + " and " +
                    number_text(kLongestDirection) +
                    ", or the vector has no direction; give numbers near 1, such as [0, 1, 0]");
  return *direction;
}

std::optional<std::size_t> TableReader::chosen(const std::string& key,
                                               const std::vector<std::string>& words) {
  const auto value = text(key);
  if (!value) return std::nullopt;
  const auto match = std::find(words.begin(), words.end(), *value);
  if (match != words.end()) return static_cast<std::size_t>(match - words.begin());
  const auto meant = nearest_key(*value, words);
  reject(key, "allowed: " + listed(words) + (meant ? "; did you mean \"" + one_line(*meant) + "\"?" : ""));
}

std::optional<TableReader> TableReader::table(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) {
    const std::string header = '[' + full_key(key) + ']';
    reject_node(*node, key, "expected one table: write " + header + " on its own line with its keys below");
  }
  return TableReader(*node->as_table(), file_, full_key(key), written_);
}

TableReader TableReader::required_table(const std::string& key) {
  require(key, "a table [" + full_key(key) + "] with its keys below it");
  return *table(key);
}

std::vector<TableReader> TableReader::tables(const std::string& key) {
  std::vector<TableReader> readers;
  const toml::node* node = find(key);
  if (node == nullptr) return readers;
  const toml::array* list = node->as_array();
  const std::string header = "[[" + full_key(key) + "]]";
  const std::string needed =
      "expected a list of tables: write " + header + " with double brackets above the keys of each";
  if (list == nullptr) reject_node(*node, key, needed);
  refuse_long(*list, where(key));
  for (const toml::node& element : *list) {
    if (!element.is_table()) reject_node(element, key, needed);
    readers.emplace_back(*element.as_table(), file_, full_key(key), written_);
  }
  return readers;
}

void TableReader::finish() const {
  for (const auto& [name, value] : *table_) {
    const std::string key(name.str());
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string at = named(name.source(), key);
    const auto meant = nearest_key(key, known_);
    std::string remedy;
    if (meant) {
      remedy = "did you mean \"" + *meant + "\"?";
    } else {
      remedy = "the allowed keys are ";
      for (const std::string& known : known_) remedy += (known == known_.front() ? "" : ", ") + known;
    }
    throw SceneError(at + ": found " + shown_value(value) + " under an unknown key; " + remedy);
  }
}

}  // namespace diefill::process
