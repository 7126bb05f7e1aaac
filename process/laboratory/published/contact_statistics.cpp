#include "process/laboratory/published/contact_statistics.h"

#include <algorithm>
#include <cmath>

#include "geometry/voronoi/neighbour_grid.h"
#include "process/measure/period.h"

namespace diefill::process::laboratory {
namespace {

/// Mean number of distinct neighbours of the grains that count.
double mean_contacts(std::vector<std::vector<std::uint32_t>>& touching, const std::vector<bool>& counts) {
  double sum = 0;
  for (auto& neighbours : touching) {
    std::sort(neighbours.begin(), neighbours.end());
    const auto last = std::unique(neighbours.begin(), neighbours.end());
    sum += static_cast<double>(last - neighbours.begin());
  }
  return sum / std::max(1.0, static_cast<double>(std::count(counts.begin(), counts.end(), true)));
}

}  // namespace

std::vector<bool> away_from_ends(const results::PowderState& powder, double margin) {
  double top = 0;
  for (const auto& place : powder.position) top = std::max(top, place.z());
  const double away = margin * powder.grain_diameter;
  std::vector<bool> counts;
  for (const auto& place : powder.position)
    counts.push_back(margin == 0 || (place.z() > away && place.z() < top - away));
  return counts;
}

ContactStatistics contact_statistics(const results::PowderState& powder, double bin, double margin) {
  constexpr std::size_t kBins = 200;
  const double d = powder.grain_diameter, reach = 2 * powder.largest_sphere_radius();
  const auto all = geometry::with_periodic_images(powder.sphere_centres(), period_of(powder), reach);
  const auto grain_of = powder.grains_of_spheres();
  const auto counts = away_from_ends(powder, margin);
  const geometry::NeighbourGrid grid(all.points, reach);
  std::vector<double> histogram(kBins, 0.0);
  std::vector<std::vector<std::uint32_t>> touching(powder.position.size());
  double sum = 0, contacts = 0;
  for (std::size_t k = 0; k < grain_of.size(); ++k) {
    if (!counts[grain_of[k]]) continue;
    grid.for_each_within(all.points[k], reach, [&](std::uint32_t other, const auto&, double squared) {
      const std::uint32_t neighbour = grain_of[all.source[other]];
      if (neighbour == grain_of[k]) return;
      const double overlap = (reach - std::sqrt(squared)) / d;
      touching[grain_of[k]].push_back(neighbour);
      sum += overlap;
      ++contacts;
      ++histogram[std::min(kBins - 1, static_cast<std::size_t>(overlap / bin))];
    });
  }
  ContactStatistics statistics;
  statistics.contacts_a_grain = mean_contacts(touching, counts);
  statistics.mean_overlap = sum / std::max(1.0, contacts);
  for (std::size_t b = 0; b < kBins; ++b) {
    statistics.overlap.push_back((static_cast<double>(b) + 0.5) * bin);
    statistics.share.push_back(histogram[b] / std::max(1.0, contacts));
  }
  const auto peak = std::max_element(histogram.begin(), histogram.end()) - histogram.begin();
  statistics.peak_overlap = statistics.overlap[static_cast<std::size_t>(peak)];
  return statistics;
}

}  // namespace diefill::process::laboratory
