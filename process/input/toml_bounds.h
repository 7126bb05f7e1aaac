// How deeply a scene's text may nest tables and lists, checked before it is parsed: the parser is recursive,
// and thousands of levels would overflow its stack. Texts that are never closed are found on the way.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::process {

/// Throws SceneError with the line where keys are dotted or brackets nested more deeply than any scene needs,
/// and where a text in triple quotes begins that is never closed.
void refuse_deep_nesting(const std::string& text, const std::filesystem::path& file);

}  // namespace diefill::process
