#include "process/estimate/trapped_air.h"

#include <algorithm>
#include <limits>

#include "process/continuum/air.h"

namespace diefill::process::estimate {

namespace {

/// One crossing of the shoe over an opening.
struct Cover {
  double area = 0;     ///< m^2 that powder comes over
  double seconds = 0;  ///< s that it is over a place, mean
  double whole = 0;    ///< s that it is over all of them at once
};

Cover cover_of(const OpeningLayout& layout, const ShoePath& path, std::size_t opening, std::size_t n) {
  Cover cover;
  double begin = -std::numeric_limits<double>::infinity(), end = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    const OpeningPatch& place = layout.places[k];
    if (place.opening != opening || path.exposures[k].size() <= n) continue;
    const Exposure& exposure = path.exposures[k][n];
    cover.area += place.area;
    cover.seconds += place.area * exposure.seconds;
    begin = std::max(begin, exposure.began);
    end = std::min(end, exposure.ended());
  }
  if (!(cover.area > 0)) return cover;
  cover.seconds /= cover.area;
  cover.whole = std::max(0.0, end - begin);
  return cover;
}

/// m^2 of an opening that a punch fills at first, so that no air is below the powder.
double filled_at_first(const OpeningLayout& layout, std::size_t opening) {
  double area = 0;
  for (const OpeningPatch& place : layout.places)
    if (place.opening == opening && place.opens) area += place.area;
  return area;
}

}  // namespace

void find_trapped_air(const OpeningLayout& layout, const ShoePath& path, std::size_t k, double flux,
                      OpeningEstimate& opening) {
  if (filled_at_first(layout, k) > 0.5 * opening.area) return;
  double seconds = 0, whole = 0;
  for (std::size_t n = 0; n < path.crossings; ++n) {
    const Cover cover = cover_of(layout, path, k, n);
    seconds += cover.seconds;
    if (cover.area >= kWhole * opening.area) whole += cover.whole;
  }
  if (!(whole > 0)) return;
  opening.air_trapped = std::min(1.0, whole / seconds);
  opening.air_escapes = continuum::escape_time(opening.depth, flux);
  opening.air_ratio = *opening.air_escapes * opening.air_trapped / seconds;
}

}  // namespace diefill::process::estimate
