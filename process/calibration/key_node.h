// What a document of TOML has under the path of a key.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <string>

namespace diefill::process::calibration {

/// What stands at `key`, a path such as "powder.friction" (scene/key_path.h), or the list on the way to it;
/// null where nothing does.
const toml::node* node_of_key(const toml::table& document, const std::string& key);

}  // namespace diefill::process::calibration
