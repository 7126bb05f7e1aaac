#include "process/input/text_encoding.h"

#include <string_view>

#include "process/input/scene_error.h"
#include "process/input/utf8.h"
#include "process/results/formatted.h"

namespace diefill::process {
namespace {

using namespace std::literals;

std::string name_of(TextKind kind) {
  if (kind == TextKind::csv) return "table";
  return kind == TextKind::calibration ? "calibration" : "scene";
}

std::string remedy(TextKind kind) {
  return "; save the " + name_of(kind) + " as UTF-8 text";
}

/// The encoding that the first bytes show, such as "UTF-16"; empty where they show none. Scenes begin with
/// letters, so that without a mark the zeros tell.
std::string wide_encoding(std::string_view text) {
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
  if (text.size() < 4) return {};
  const auto zero = [&](std::size_t k) { return text[k] == '\0'; };
  if ((zero(0) && zero(1) && zero(2) && !zero(3)) || (!zero(0) && zero(1) && zero(2) && zero(3)))
    return "UTF-32";
  if ((zero(0) && !zero(1) && zero(2) && !zero(3)) || (!zero(0) && zero(1) && !zero(2) && zero(3)))
    return "UTF-16";
  return {};
}

std::string byte_text(char letter) {
  return results::formatted("0x%02X", static_cast<unsigned>(static_cast<unsigned char>(letter)));
}

}  // namespace

void refuse_wrong_encoding(const std::string& text, const std::filesystem::path& file, TextKind kind) {
  if (const std::string wide = wide_encoding(text); !wide.empty())
    throw SceneError(file.string() + ":1: found " + wide + " text, expected UTF-8" + remedy(kind));
  std::size_t line = 1, begin = 0;
  for (std::size_t k = 0; k < text.size();) {
    const auto place = [&] {
      return file.string() + ':' + std::to_string(line) + ':' + std::to_string(k - begin + 1);
    };
    const auto character = utf8_character(std::string_view(text).substr(k));
    if (!character)
      throw SceneError(place() + ": found the byte " + byte_text(text[k]) + ", which is not UTF-8" +
                       remedy(kind));
    const auto code = character->code;
    const bool control = (code < 0x20 && code != '\n' && code != '\r' && code != '\t') || code == 0x7F;
    if (control)
      throw SceneError(place() + ": found the byte " + std::to_string(code) +
                       ", which does not occur in a text file; give a " +
                       (kind == TextKind::csv ? "CSV " : "TOML ") + name_of(kind) + " saved as UTF-8");
    k += character->length;
    if (code == '\n') {
      ++line;
      begin = k;
    }
  }
}

}  // namespace diefill::process
