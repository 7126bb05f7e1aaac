#include "process/results/formatted.h"

#include <algorithm>
#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <utility>

namespace diefill::results {
namespace {

bool in_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0;
}

/// Takes the sign from numbers that rounding has left as "-0.00"; "-0" of "%.17g" keeps it, for the exact
/// value.
std::string without_negative_zeros(std::string text) {
  for (std::size_t at = text.find("-0."); at != std::string::npos; at = text.find("-0.", at + 1)) {
    const std::size_t end = std::min(text.find_first_not_of('0', at + 3), text.size());
    const bool begins = at == 0 || (!in_word(text[at - 1]) && text[at - 1] != '.');
    if (begins && (end == text.size() || !in_word(text[end]))) text.erase(at, 1);
  }
  return text;
}

}  // namespace

std::string formatted(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return without_negative_zeros(std::move(text));
}

}  // namespace diefill::results
