// How far grains and bodies may move at most before the neighbour list must be rebuilt.
#pragma once

#include <algorithm>

#include "engine/search/neighbour_list.h"

namespace diefill::engine {

/// m, of any grain of the list, against the drift of its group.
inline double farthest_allowance(const ListReference& reference) {
  double farthest = 0;
  for (std::size_t k = 0; k < reference.doublings.size(); ++k)
    farthest = std::max(farthest, reference.allowance(k));
  return farthest;
}

/// m, of body b, against the drift of any group.
inline double farthest_allowance_of_body(const ListReference& reference, std::size_t b) {
  double farthest = 0;
  for (std::size_t group = 0; group < reference.groups(); ++group)
    farthest = std::max(farthest, reference.allowance_of_body(b, group));
  return farthest;
}

}  // namespace diefill::engine
