#include "process/input/source_place.h"

#include <toml++/toml.h>

#include <algorithm>

namespace diefill::process {

std::string source_place(const std::filesystem::path& file, const toml::source_region& region) {
  // A value made up by the parser has no position; it belongs to the top of the file.
  const auto line = std::max<toml::source_index>(region.begin.line, 1),
             column = std::max<toml::source_index>(region.begin.column, 1);
  if (region.path && !region.path->empty()) return *region.path + ", change " + std::to_string(line);
  return file.string() + ':' + std::to_string(line) + ':' + std::to_string(column);
}

}  // namespace diefill::process
