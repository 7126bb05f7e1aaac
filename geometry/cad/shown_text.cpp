#include "geometry/cad/shown_text.h"

#include <array>
#include <cstdio>

namespace diefill::geometry {

namespace {

constexpr std::size_t kLongestPath = 1000;

/// Bytes of the UTF-8 character that begins at `at`; 0 where none does.
std::size_t bytes_of_character(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(at);
  const std::size_t bytes = first < 0x80                     ? 1
                            : first >= 0xc2 && first <= 0xdf ? 2
                            : first >= 0xe0 && first <= 0xef ? 3
                            : first >= 0xf0 && first <= 0xf4 ? 4
                                                             : 0;
  if (bytes == 0 || at + bytes > text.size()) return 0;
  for (std::size_t k = 1; k < bytes; ++k)
    if ((byte(at + k) & 0xc0U) != 0x80) return 0;
  return bytes;
}

/// Also the control characters U+0080 to U+009F.
bool is_control(std::string_view text, std::size_t at, std::size_t bytes) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (bytes == 1) return first < 0x20 || first == 0x7f;
  return bytes == 2 && first == 0xc2 && static_cast<unsigned char>(text[at + 1]) < 0xa0;
}

std::string escaped(unsigned char byte) {
  if (byte == '\n') return "\\n";
  if (byte == '\r') return "\\r";
  if (byte == '\t') return "\\t";
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "\\x%02X", byte);
  return code.data();
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    if (plain.size() >= most) return plain + "...";
    const std::size_t bytes = bytes_of_character(text, at);
    if (bytes > 0 && !is_control(text, at, bytes)) {
      plain += text.substr(at, bytes);
      at += bytes;
    } else {
      plain += escaped(static_cast<unsigned char>(text[at++]));
    }
  }
  return plain;
}

std::string named(const std::filesystem::path& file) {
  return "CAD file '" + shown(file.string(), kLongestPath) + "'";
}

std::string as_utf8(const std::string& text) {
  bool is_utf8 = true;
  for (std::size_t at = 0; at < text.size() && is_utf8;) {
    const std::size_t bytes = bytes_of_character(text, at);
    is_utf8 = bytes > 0;
    at += bytes;
  }
  if (is_utf8) return text;
  std::string converted;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80) {
      converted += letter;
      continue;
    }
    converted += static_cast<char>(0xc0U | byte >> 6U);
    converted += static_cast<char>(0x80U | (byte & 0x3fU));
  }
  return converted;
}

}  // namespace diefill::geometry
