#include "process/calibration/key_node.h"

#include <toml++/toml.h>

#include "process/scene/key_path.h"

namespace diefill::process::calibration {

const toml::node* node_of_key(const toml::table& document, const std::string& key) {
  const toml::node* node = &document;
  for (const std::string& name : key_names(key)) {
    const toml::table* table = node->as_table();
    if (table == nullptr) return node;
    node = table->get(name);
    if (node == nullptr) return nullptr;
  }
  return node;
}

}  // namespace diefill::process::calibration
