// Figures of items that a scene names, such as zones and heaps.
#pragma once

#include <algorithm>
#include <string>

#include "process/results/figure_table.h"

namespace diefill::results {

/// Whether the entry stands for the figures of all items of a kind.
inline bool is_per_item(const Figure& figure) {
  return std::string(figure.name).find('*') != std::string::npos;
}

/// "flange" of the figure "solid_fraction_in_flange"; spaces for underscores.
inline std::string item_of(const Figure& figure, const std::string& name) {
  const std::string pattern = figure.name;
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos || name.size() + 1 < pattern.size()) return {};
  std::string item = name.substr(star, name.size() + 1 - pattern.size());
  std::replace(item.begin(), item.end(), '_', ' ');
  return item;
}

}  // namespace diefill::results
