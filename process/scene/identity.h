// Whether two scenes ask for the same computation:
// the condition for resuming a run, and for keeping results.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace diefill::process {

/// The document in `text` without what does not affect the computation: title, variants, numerics.max_time
/// and numerics.checkpoint_interval; comments and the order of keys go with the text. `file` stands in
/// messages. Throws SceneError for text that is not TOML.
toml::table relevant_document(const std::string& text, const std::filesystem::path& file);

/// Number that two scenes share if they ask for the same computation with the same files: hash of the text
/// that affects the computation, of `tool_hashes` (the tools' CAD files, tool by tool) and of the files that
/// it refers to as they are now (`file` resolves their paths). Throws SceneError for text that is not TOML.
std::uint64_t scene_identity(const std::string& text, const std::filesystem::path& file,
                             const std::vector<std::string>& tool_hashes);

/// A file that a scene refers to, other than CAD: spheres of clumps, placed grains, the results of
/// pour.state, a table that a step follows.
struct InputFile {
  std::string name;  ///< as the scene has it
  std::string hash;  ///< of its contents
};

/// All such files as they are now, for results to keep: later the same names may hold something else. Throws
/// SceneError for text that is not TOML.
std::vector<InputFile> input_files(const std::string& text, const std::filesystem::path& file);

/// The names of all such files in a scene's document, in the order of input_files().
std::vector<std::string> input_names(const toml::table& document);

/// Hash of the one of `files` with that name. Throws std::logic_error where there is none.
const std::string& hash_of_input(const std::vector<InputFile>& files, const std::string& name);

}  // namespace diefill::process
