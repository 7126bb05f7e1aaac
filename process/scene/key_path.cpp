#include "process/scene/key_path.h"

#include <toml++/toml.h>

#include "process/input/scene_error.h"
#include "process/scene/scene_text.h"

namespace diefill::process {

bool is_key_path(const std::string& key) {
  if (key.find_first_of("\r\n") != std::string::npos) return false;
  const std::string value = "the value that this key is given";  // no key brings it along by itself
  try {
    const toml::table document = parse_scene_text(key + " = \"" + value + '"', "key");
    const toml::node* node = &document;
    while (const toml::table* table = node->as_table()) {
      if (table->size() != 1) return false;
      node = &table->begin()->second;
    }
    return node->value_exact<std::string>() == value;
  } catch (const SceneError&) {
    return false;
  }
}

std::vector<std::string> key_names(const std::string& key) {
  const toml::table document = parse_scene_text(key + " = 0", "key");
  std::vector<std::string> names;
  for (const toml::table* table = &document; table != nullptr && !table->empty();
       table = table->begin()->second.as_table())
    names.emplace_back(table->begin()->first.str());
  return names;
}

}  // namespace diefill::process
