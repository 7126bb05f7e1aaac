#include "process/input/shown_value.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>

#include "process/input/utf8.h"

namespace diefill::process {
namespace {

/// Fewest digits that name the number: 1.88, not 1.8799999999999999.
std::string shortest(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc() ? std::string(buffer.data(), end) : std::to_string(value);
}

/// Control characters, line separators, and what reverses, joins or hides text.
bool is_displayable(std::uint32_t code) {
  const auto between = [code](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return !(code < 0x20 || between(0x7F, 0x9F) || code == 0xAD || code == 0x61C || code == 0x200B ||
           between(0x200E, 0x200F) || between(0x2028, 0x202E) || between(0x2060, 0x206F) || code == 0xFEFF ||
           between(0xFFF0, 0xFFFB) || between(0xE0000, 0xE0FFF));
}

/// As TOML writes it.
std::string escaped(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), code > 0xFFFF ? "\\U%08X" : "\\u%04X", static_cast<unsigned>(code));
  return text.data();
}

std::string escaped_byte(unsigned char byte) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "\\x%02X", static_cast<unsigned>(byte));
  return text.data();
}

bool is_inside_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Beginning and end of a word, cut between characters.
std::string shortened(std::string_view word, std::size_t longest) {
  constexpr std::string_view kLeftOut = "...";
  const std::size_t kept = longest - std::min(longest, kLeftOut.size());
  std::size_t first = kept - kept / 2, last = word.size() - kept / 2;
  while (first > 0 && is_inside_character(word[first])) --first;
  while (last < word.size() && is_inside_character(word[last])) ++last;
  return std::string(word.substr(0, first)) + std::string(kLeftOut) + std::string(word.substr(last));
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

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const auto character = utf8_character(text);
    if (!character || !is_displayable(character->code)) return false;
    text.remove_prefix(character->length);
  }
  return true;
}

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line;
  while (!text.empty()) {
    const auto character = utf8_character(text);
    const std::size_t length = character ? character->length : 1;
    const bool plain = character && is_displayable(character->code);
    const std::string shown = plain       ? std::string(text.substr(0, length))
                              : character ? escaped(character->code)
                                          : escaped_byte(static_cast<unsigned char>(text.front()));
    if (shown.size() > longest || line.size() > longest - shown.size()) return line + "...";
    line += shown;
    text.remove_prefix(length);
  }
  return line;
}

std::string with_short_words(std::string_view text, std::size_t longest) {
  constexpr std::string_view kBlanks = " \t\n\r";
  std::string shown;
  while (!text.empty()) {
    const std::size_t end = std::min(text.size(), text.find_first_of(kBlanks));
    const std::string_view word = text.substr(0, end);
    shown += word.size() > longest ? shortened(word, longest) : std::string(word);
    const std::size_t next = std::min(text.size(), text.find_first_not_of(kBlanks, end));
    shown += text.substr(end, next - end);
    text.remove_prefix(next);
  }
  return shown;
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
