// Columns of names in tables on the terminal.
#pragma once

#include <cstddef>
#include <string>

namespace diefill::app {

inline constexpr std::size_t kWidestName = 48;  ///< letters; longer names push the numbers on

/// Letters of a UTF-8 text: bytes that begin one.
inline std::size_t character_count(const std::string& text) {
  std::size_t letters = 0;
  for (const char byte : text) letters += (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U ? 1 : 0;
  return letters;
}

/// The text padded with blanks to `width` letters.
inline std::string padded(const std::string& text, std::size_t width) {
  const std::size_t letters = character_count(text);
  return letters >= width ? text : text + std::string(width - letters, ' ');
}

}  // namespace diefill::app
