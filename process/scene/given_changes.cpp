#include "process/scene/given_changes.h"

#include <toml++/toml.h>

#include <algorithm>

#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

constexpr const char* kOption = "--set";

[[noreturn]] void refuse_nothing_changed(const std::string& found) {
  throw SceneError(std::string(kOption) + ": found `" + found +
                   "`, which changes no key; expected a key and its value, such as 'step.1.velocity = \"0.1 "
                   "m/s\"'");
}

/// Whether all that stands there is a comment.
bool is_comment(const std::string& change) {
  const std::size_t first = change.find_first_not_of(" \t");
  return first == std::string::npos || (change[first] == '#' && change.find('\n') == std::string::npos);
}

/// Path of a table without keys; empty where there is none.
std::string empty_table_in(const toml::table& table, const std::string& path) {
  for (const auto& [key, node] : table) {
    const toml::table* inner = node.as_table();
    if (inner == nullptr) continue;
    const std::string name = path + (path.empty() ? "" : ".") + std::string(key.str());
    if (inner->empty()) return name;
    if (std::string below = empty_table_in(*inner, name); !below.empty()) return below;
  }
  return {};
}

}  // namespace

void refuse_changes_of_nothing(const std::vector<std::string>& changes) {
  std::string all;
  for (const std::string& change : changes) {
    if (is_comment(change)) refuse_nothing_changed(one_line(change));
    all += change + '\n';  // the keys of a table may follow its header in a text of their own
  }
  const std::string empty = empty_table_in(parse_changes(all, kOption), "");
  if (!empty.empty()) refuse_nothing_changed('[' + one_line(empty) + ']');
}

}  // namespace diefill::process
