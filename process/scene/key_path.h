// Paths of keys as users give them outside a scene: to a calibration, to --vary.
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// Whether `key` is the path of one key, such as `step.1.velocity` or `tool."core rod".position`: put before
/// " = 1" it sets that key. False for text that brings a value or a comment of its own, such as
/// `powder.friction = 3 #`, after which the value would be lost.
bool is_key_path(const std::string& key);

/// The names of a key path, the outermost first: {"powder", "friction"} of `powder."friction"`. Throws
/// SceneError for text that is no TOML.
std::vector<std::string> key_names(const std::string& key);

}  // namespace diefill::process
