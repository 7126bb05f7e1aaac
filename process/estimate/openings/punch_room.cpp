#include "process/estimate/openings/punch_room.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::estimate {

namespace {

/// s at which crossing `n` of the shoe over an opening ends, the mean over its area; nothing where it has
/// none.
std::optional<double> end_of(const OpeningLayout& layout, const ShoePath& path, std::size_t opening,
                             std::size_t n) {
  double area = 0, end = 0;
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    if (layout.places[k].opening != opening || path.exposures[k].size() <= n) continue;
    area += layout.places[k].area;
    end += layout.places[k].area * path.exposures[k][n].ended();
  }
  if (!(area > 0)) return std::nullopt;
  return end / area;
}

/// Share of the punch's stroke that it does during an exposure.
double done_in(const FallingPunch& punch, const Exposure& exposure) {
  return punch.progress(exposure.ended()) - punch.progress(exposure.began);
}

}  // namespace

std::vector<PunchRoom> punch_room(const OpeningLayout& layout, const ShoePath& path,
                                  const InflowPowder& powder, std::size_t opening) {
  std::vector<PunchRoom> rooms;
  const FillOpening& cavity = layout.openings[opening];
  const double own = running_speed(powder, effective_width(cavity.width, powder));
  for (std::size_t n = 0; n < path.crossings; ++n) {
    PunchRoom room = rooms.empty() ? PunchRoom{} : rooms.back();
    const auto end = end_of(layout, path, opening, n);
    double missing = 0;
    for (std::size_t k = 0; k < layout.places.size(); ++k) {
      const OpeningPatch& place = layout.places[k];
      if (place.opening != opening || !place.punch) continue;
      const FallingPunch& punch = layout.punches[*place.punch];
      if (end) missing += place.area * punch.stroke * (1 - punch.progress(*end));
      if (path.exposures[k].size() <= n) continue;
      const double done = done_in(punch, path.exposures[k][n]);
      room.made += place.area * punch.stroke * done;
      room.running += place.area * own * (punch.ended - punch.began) * done;
    }
    if (end && cavity.volume > 0) room.share = std::clamp(1 - missing / cavity.volume, 0.0, 1.0);
    rooms.push_back(room);
  }
  return rooms;
}

double covered_share(const OpeningLayout& layout, const ShoePath& path, std::size_t punch) {
  double area = 0, covered = 0;
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    if (layout.places[k].punch != punch) continue;
    area += layout.places[k].area;
    for (const Exposure& exposure : path.exposures[k])
      covered += layout.places[k].area * done_in(layout.punches[punch], exposure);
  }
  return area > 0 ? covered / area : 0;
}

double running_speed(const InflowPowder& powder, double width) {
  if (!(width > 0)) return 0;
  const double x = std::min(powder.law.longest, 1e3);
  return continuum::rate_share(powder.law.numbers, x) * std::sqrt(powder.gravity * width);
}

}  // namespace diefill::process::estimate
