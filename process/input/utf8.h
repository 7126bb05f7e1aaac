// Characters of a text in UTF-8.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace diefill::process {

/// A character and the bytes it takes.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t length = 1;
};

/// The character that `text` (not empty) begins with; nothing where its first bytes are not UTF-8.
std::optional<Utf8Character> utf8_character(std::string_view text);

}  // namespace diefill::process
