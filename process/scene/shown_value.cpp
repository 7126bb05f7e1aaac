#include "process/scene/shown_value.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace diefill::process {
namespace {

/// Fewest digits that name the number: 1.88, not 1.8799999999999999.
std::string shortest(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc() ? std::string(buffer.data(), end) : std::to_string(value);
}

/// A point or axis as it was written; longer lists and lists of tables by their length.
std::string shown_list(const toml::array& list) {
  const bool plain =
      list.size() <= 4 && std::none_of(list.begin(), list.end(), [](const toml::node& element) {
        return element.is_table() || element.is_array();
      });
  if (!plain) return "a list of " + std::to_string(list.size()) + (list.size() == 1 ? " entry" : " entries");
  std::string values;
  for (const toml::node& element : list) values += (values.empty() ? "" : ", ") + shown_value(element);
  return '[' + values + ']';
}

}  // namespace

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line;
  for (const char letter : text) {
    if (line.size() >= longest) {
      // Cut before a character of several bytes, never within it.
      while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U) line.pop_back();
      if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xC0U) line.pop_back();
      return line + "...";
    }
    const auto code = static_cast<unsigned char>(letter);
    line += code < 0x20U || code == 0x7FU ? ' ' : letter;
  }
  return line;
}

std::string shown_value(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return '"' + one_line(*text) + '"';
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto number = node.value_exact<double>()) return shortest(*number);
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  if (node.is_table()) return "a table";
  if (const toml::array* list = node.as_array()) return shown_list(*list);
  return "a date or time";
}

}  // namespace diefill::process
