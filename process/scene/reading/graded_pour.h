// `graded` of [pour]: grains that flow into the cavity are fine, those above them in the shoe are the same
// powder in larger grains, which cost less.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <filesystem>

namespace diefill::process {

/// Where [pour] of the document has `graded`, puts a powder of larger grains ([[other_powder]]) and two
/// layers in its place, fine grains below. Throws SceneError for wrong values, and beside other powders,
/// layers, several sizes and grains that are placed already.
void apply_graded_pour(toml::table& document, const std::filesystem::path& file);

}  // namespace diefill::process
