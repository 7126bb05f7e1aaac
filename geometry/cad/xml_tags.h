// Tags of XML text, as far as CAD files need them: no library here reads XML.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace diefill::geometry {

/// `text` without the blanks of XML at both ends.
std::string_view without_blanks(std::string_view text);

/// `document` without its comments, which may hold tags; without a mark of UTF-8 at the beginning too.
std::string without_comments(std::string document);

/// Calls `look(name, value)` for every attribute of a tag; `attributes` as they stand in it, after its name.
template <class Look>
void visit_attributes(std::string_view attributes, Look look) {
  for (std::size_t at = 0; at < attributes.size();) {
    const std::size_t equals = attributes.find('=', at);
    const std::size_t open = attributes.find_first_of("\"'", equals);
    if (equals == std::string_view::npos || open == std::string_view::npos) return;
    const std::size_t close = attributes.find(attributes[open], open + 1);
    if (close == std::string_view::npos) return;
    look(without_blanks(attributes.substr(at, equals - at)), attributes.substr(open + 1, close - open - 1));
    at = close + 1;
  }
}

/// The value of that attribute; nothing where the tag has none.
std::optional<std::string> attribute(std::string_view attributes, std::string_view name);

/// Calls `look(name, attributes, rest)` for every tag, "/name" for one that closes; the name comes without a
/// prefix such as "m:", and `rest` is what follows the tag.
template <class Look>
void visit_tags(std::string_view document, Look look) {
  for (std::size_t at = document.find('<'); at != std::string_view::npos; at = document.find('<', at + 1)) {
    const std::size_t end = document.find('>', at);
    if (end == std::string_view::npos) return;
    const std::string_view tag = document.substr(at + 1, end - at - 1);
    const std::size_t blank = std::min(tag.find_first_of(" \t\r\n/", 1), tag.size());
    const std::string_view name = tag.substr(0, blank);
    look(name.substr(name.rfind(':') + 1), tag.substr(blank), document.substr(end + 1));
  }
}

}  // namespace diefill::geometry
