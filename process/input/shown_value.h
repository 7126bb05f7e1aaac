// How texts and values of the scene file are quoted in a message: on one line, short, without control
// characters.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <string>
#include <string_view>

namespace diefill::process {

/// Whether `text` is one line that a terminal shows as it stands: valid UTF-8 without control characters and
/// without characters that reverse or hide text.
bool is_printable(std::string_view text);

/// `text` with the characters that is_printable() refuses written out, such as `\n`, `\u001B` or `\xE9` for a
/// byte that is not UTF-8.
std::string printable(std::string_view text);

/// The same, of at most `longest` bytes: the rest is cut off with "...".
std::string one_line(std::string_view text, std::size_t longest = 60);

/// Such as `"1.88"` for a text, `1.88` for a number, `[0, 0, 1]` for a short list, "a table".
std::string shown_value(const toml::node& node);

}  // namespace diefill::process
