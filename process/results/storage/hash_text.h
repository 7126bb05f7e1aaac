// A hash of 64 bits as text.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace diefill::results {

/// 16 hexadecimal digits, with leading zeros.
inline std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace diefill::results
