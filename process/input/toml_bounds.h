// How deeply a scene's text may nest tables and lists, checked before it is parsed: the parser is recursive,
// and thousands of levels would overflow its stack.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::process {

/// Throws SceneError with the line where keys are dotted or brackets nested more deeply than any scene needs.
void refuse_deep_nesting(const std::string& text, const std::filesystem::path& file);

}  // namespace diefill::process
