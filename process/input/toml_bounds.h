// How deeply a scene's text may nest tables and lists, seen before it is parsed: the parser follows keys such
// as a.b.c and brackets by calling itself, and thousands of them would use up its stack.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::process {

/// Throws SceneError with the line where keys are dotted or brackets nested more deeply than any scene needs.
void refuse_deep_nesting(const std::string& text, const std::filesystem::path& file);

}  // namespace diefill::process
