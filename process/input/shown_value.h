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

/// `text` as one printable line of at most `longest` bytes, the rest cut off with "...".
std::string one_line(std::string_view text, std::size_t longest = 60);

/// `text` with what is longer than `longest` bytes between two blanks, such as the path of a file, shortened
/// in its middle with "...".
std::string with_short_words(std::string_view text, std::size_t longest = 400);

/// Such as `"1.88"` for a text, `1.88` for a number, `[0, 0, 1]` for a short list, "a table".
std::string shown_value(const toml::node& node);

}  // namespace diefill::process
