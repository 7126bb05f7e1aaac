// How a value of the scene file is quoted in a message: on one line, short, without control characters.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <string>
#include <string_view>

namespace diefill::process {

/// `text` on one line of at most `longest` characters: control characters become spaces, the rest is cut off
/// with "...".
std::string one_line(std::string_view text, std::size_t longest = 60);

/// Such as `"1.88"` for a text, `1.88` for a number, `[0, 0, 1]` for a short list, "a table".
std::string shown_value(const toml::node& node);

}  // namespace diefill::process
