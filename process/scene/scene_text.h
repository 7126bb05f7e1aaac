// The scene file as text: found, readable, and really text.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <filesystem>
#include <string>

namespace diefill::process {

/// The bytes of `file`. Throws SceneError when it is missing, a folder, not readable or too large to be a
/// scene.
std::string load_scene_text(const std::filesystem::path& file);

/// The document in `text`; `file` stands in messages. Throws SceneError for text that is not TOML, with the
/// line and, for common mistakes, the remedy.
toml::table parse_scene_text(const std::string& text, const std::filesystem::path& file);

/// The same of changes to a scene, a key a line: messages about them, also later ones about values, name
/// `called` (such as "--set") and which change it is.
toml::table parse_changes(const std::string& text, const std::string& called);

/// The document as the text of a scene file, numbers with as few digits as give them back.
std::string scene_text_of(const toml::table& document);

/// A line of a scene that gives `key` (with its table) a number: `a.b = 1`, or `a.b = "1 mm"` where `unit` is
/// not "1". `number` stands as given, so that its digits are the caller's choice.
std::string assignment_line(const std::string& key, const std::string& number, const std::string& unit);

}  // namespace diefill::process
