// A surface in ranges (stretches) of some thousand triangles, facet by facet: tasks for threads.
// The ranges depend on the surface alone,
// so sums over stretches have the same bits on any number of threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/surface_facets.h"

namespace diefill::geometry {

/// From one triangle of a facet to one of the same or a later facet.
struct Stretch {
  std::size_t first_facet = 0, first_triangle = 0;  ///< triangle: place in Facet::triangles
  std::size_t last_facet = 0, end_triangle = 0;     ///< first triangle of the last facet that is not in it
  std::size_t number = 0;                           ///< how many come before
};

/// All triangles in order, in stretches; a large facet may be in several.
std::vector<Stretch> stretches_of(const Facets& facets);

/// Calls `visit(facet, begin, end, whole)` for the facets of a stretch: the places of their triangles in it,
/// and whether these are the facet's last.
template <typename Visit>
void visit_facets(const Facets& facets, const Stretch& stretch, Visit visit) {
  for (std::size_t f = stretch.first_facet; f <= stretch.last_facet; ++f) {
    const std::size_t all = facets[f].triangles.size();
    const std::size_t begin = f == stretch.first_facet ? stretch.first_triangle : 0;
    const std::size_t end = f == stretch.last_facet ? stretch.end_triangle : all;
    visit(f, begin, end, end == all);
  }
}

/// Calls `take(work(stretch))` for every stretch: `work` on all cores, `take` one after the other in order,
/// never both at once. The result of `work` may be large: only some dozens of them exist at a time, and fewer
/// at first, so that later work sees what was taken early.
template <typename Work, typename Take>
void work_and_take(const std::vector<Stretch>& stretches, Work work, Take take) {
  constexpr std::size_t kMaxAtATime = 64;
  std::vector<decltype(work(stretches.front()))> results;
  std::size_t count = 1;
  for (std::size_t begin = 0; begin < stretches.size(); begin += results.size()) {
    results.assign(std::min(count, stretches.size() - begin), {});
    on_all_cores(results.size(), [&](std::size_t i) { results[i] = work(stretches[begin + i]); });
    for (const auto& result : results) take(result);
    count = std::min(2 * count, kMaxAtATime);
  }
}

/// The same for work that does not depend on what was taken: one core takes while others work on what comes
/// next.
template <typename Work, typename Take>
void work_while_taking(const std::vector<Stretch>& stretches, Work work, Take take) {
  constexpr std::size_t kAtATime = 64;
  std::vector<decltype(work(stretches.front()))> results, taken;
  for (std::size_t begin = 0; begin < stretches.size() || !results.empty(); begin += results.size()) {
    std::swap(results, taken);
    results.assign(std::min(kAtATime, stretches.size() - begin), {});
    on_all_cores(results.size() + 1, [&](std::size_t i) {
      if (i > 0) {
        results[i - 1] = work(stretches[begin + i - 1]);
      } else {
        for (const auto& result : taken) take(result);
      }
    });
  }
}

}  // namespace diefill::geometry
