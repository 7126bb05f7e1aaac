// Variants of a scene: [[variant]] tables that each name a way of filling and change some keys of the scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process {

/// One way of filling, to be compared with others.
struct Variant {
  std::string name;    ///< as the scene gives it
  std::string folder;  ///< of its results (folder_names.h); once in a scene
  Scene scene;         ///< changes applied; `text` is a scene file of its own without variants
};

/// All variants of a scene file in their order, each read and checked in full; the scene as it stands, named
/// "as it is", where it has none. Throws SceneError for the first fault found: of the scene itself, or of a
/// variant, naming the line in the variant.
std::vector<Variant> read_variants(const std::filesystem::path& file);

/// Whether the scene's text has [[variant]] tables.
bool has_variants(const Scene& scene);

/// Changes to a scene file.
struct SceneChanges {
  std::string set;  ///< TOML, such as `step.1.velocity = "0.1 m/s"`, a key a line
  std::vector<std::string>
      without;                   ///< keys of the file that are taken out first, such as "numerics.time_step"
  std::string source = "--set";  ///< where `set` comes from, for messages
  std::string under = {};        ///< TOML laid over the file before `set`, which may give a key of it again
};

/// The scene in `text` (`file` stands in messages and resolves relative paths) with the changes, read and
/// checked in full; its variants are ignored. Its `text` is a scene file of its own. Throws SceneError;
/// faults of the changes name `changes.source` and which line of `changes.set` it is.
Scene changed_scene(const std::string& text, const std::filesystem::path& file, const SceneChanges& changes);

/// What the text has at `key`, a path such as `step.1.velocity` or `tool."core rod".position`, as the user
/// would write it after `--vary`; nothing where it has none. Throws SceneError for a path that is none.
std::optional<std::string> value_at(const std::string& text, const std::filesystem::path& file,
                                    const std::string& key);

/// The scene file's text of `scene` (one of read_variants) with this seed. Paths of files that it names, CAD
/// of a tool or the table of a step, are replaced by what `elsewhere` gives for them. The comment of a
/// setting stays at its top (process/scene/setting.h).
std::string scene_text_with(const Scene& scene, std::uint64_t seed,
                            const std::function<std::string(const std::filesystem::path&)>& elsewhere);

}  // namespace diefill::process
