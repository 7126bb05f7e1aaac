#include "geometry/cad/xml_tags.h"

namespace diefill::geometry {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string without_comments(std::string document) {
  constexpr std::string_view kMark = "\xef\xbb\xbf", kOpen = "<!--", kClose = "-->";
  std::string kept;
  std::size_t at = document.starts_with(kMark) ? kMark.size() : 0;
  for (;;) {
    const std::size_t open = document.find(kOpen, at);
    if (open == std::string::npos) break;
    const std::size_t close = document.find(kClose, open + kOpen.size());
    kept.append(document, at, open - at);
    at = close == std::string::npos ? document.size() : close + kClose.size();
  }
  if (at == 0) return document;
  return kept.append(document, at);
}

std::optional<std::string> attribute(std::string_view attributes, std::string_view name) {
  std::optional<std::string> found;
  visit_attributes(attributes, [&](std::string_view each, std::string_view value) {
    if (each == name) found = std::string(value);
  });
  return found;
}

}  // namespace diefill::geometry
