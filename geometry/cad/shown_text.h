// Text from files, made safe for one line of a message.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace diefill::geometry {

/// `text` with control characters and bytes that are no UTF-8 written as \n or \xE9, cut to about `most`
/// bytes.
std::string shown(std::string_view text, std::size_t most = 160);

/// "CAD file 'NAME'", the name as shown() has it.
std::string named(const std::filesystem::path& file);

/// `text` in UTF-8: unchanged where it is, else taken for ISO 8859-1, as older CAD programs write names.
std::string as_utf8(const std::string& text);

}  // namespace diefill::geometry
