#include "geometry/cad/percent_decoding.h"

#include <charconv>

namespace diefill::geometry {

std::string percent_decoded(const std::string& text) {
  std::string plain;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned code = 0;
    const char* const digits = text.data() + k + 1;
    const bool escaped = text[k] == '%' && k + 2 < text.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    plain += escaped ? static_cast<char>(code) : text[k];
    if (escaped) k += 2;
  }
  return plain;
}

}  // namespace diefill::geometry
