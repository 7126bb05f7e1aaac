#include "geometry/solid/surface_stretches.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxTriangles = 4096;
constexpr std::size_t kStretches = 256;  // at least, of small surfaces: a triangle may be large

/// Triangles of a stretch.
std::size_t length_for(const Facets& facets) {
  std::size_t all = 0;
  for (const Facet& facet : facets) all += facet.triangles.size();
  return std::clamp(all / kStretches, std::size_t{1}, kMaxTriangles);
}

}  // namespace

std::vector<Stretch> stretches_of(const Facets& facets) {
  const std::size_t length = length_for(facets);
  std::vector<Stretch> stretches;
  Stretch stretch;
  std::size_t taken = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::size_t all = facets[f].triangles.size();
    std::size_t end = 0;
    while (taken + all - end >= length) {
      end += length - taken;
      stretch.last_facet = f;
      stretch.end_triangle = end;
      stretches.push_back(stretch);
      ++stretch.number;
      stretch.first_facet = end < all ? f : f + 1;
      stretch.first_triangle = end < all ? end : 0;
      taken = 0;
    }
    taken += all - end;
  }
  if (taken == 0) return stretches;
  stretch.last_facet = facets.size() - 1;
  stretch.end_triangle = facets.back().triangles.size();
  stretches.push_back(stretch);
  return stretches;
}

}  // namespace diefill::geometry
