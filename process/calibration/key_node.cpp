#include "process/calibration/key_node.h"

#include <toml++/toml.h>

#include "process/scene/scene_text.h"

namespace diefill::process::calibration {

const toml::node* node_of_key(const toml::table& document, const std::string& key) {
  const toml::table path = parse_scene_text(key + " = 0", "key");
  const toml::node* node = &document;
  for (const toml::table* names = &path; names != nullptr && !names->empty() && node != nullptr;
       names = names->begin()->second.as_table()) {
    const toml::table* table = node->as_table();
    if (table == nullptr) break;
    node = table->get(names->begin()->first.str());
  }
  return node;
}

}  // namespace diefill::process::calibration
