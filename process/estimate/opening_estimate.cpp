#include "process/estimate/opening_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "process/estimate/discharge/filling.h"
#include "process/estimate/openings/punch_room.h"
#include "process/estimate/trapped_air.h"

namespace diefill::process::estimate {

namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

FillSpace space_of(const OpeningEstimate& opening) {
  return {opening.depth, opening.width};
}

/// kg in the cavity of what is offered to it, if the inflow is `factor` times that of the formula. What a
/// punch makes room for below powder follows it; the rest falls into what is left of the cavity by then.
double kept(const OpeningEstimate& opening, const PunchRoom& room, double offered, double factor = 1) {
  if (!(opening.full_mass > 0)) return 0;
  const double there = room.share * opening.full_mass;
  const double behind = opening.full_mass / opening.volume * std::min(room.made, factor * room.running);
  const double followed = std::min({offered, there, behind});
  const FillSpace left = {
      std::max(0.0, room.share * opening.depth - followed / opening.full_mass * opening.depth),
      opening.width};
  const double height = (offered - followed) / opening.full_mass * opening.depth;
  return followed + filled_height(left, height) / opening.depth * opening.full_mass;
}

/// While a punch still falls, no more is offered than there is room for: what comes later finds what it makes
/// afterwards.
void cap_by_room(const std::vector<PunchRoom>& rooms, OpeningEstimate& opening) {
  double before = 0;
  for (std::size_t n = 0; n < opening.offered.size(); ++n) {
    if (rooms[n].share < 1 - 1e-6)
      opening.offered[n] =
          std::clamp(opening.offered[n], 0.0, std::max(0.0, rooms[n].share * opening.full_mass - before));
    before += opening.offered[n];
  }
}

/// A cavity that is open below the powder while that is poured is full when that rests.
void fill_by_pour(const KnownError& error, OpeningEstimate& opening) {
  if (!opening.offered.empty()) opening.offered[0] = std::max(opening.offered[0], opening.full_mass);
  opening.mass.assign(opening.offered.size(), opening.full_mass);
  opening.least_mass = opening.full_mass * (1 - error.packing);
  opening.most_mass = opening.full_mass * (1 + error.packing);
  opening.share = opening.least_share = opening.most_share = 1;
  opening.crossings = 1;
}

/// What stays in the opening after each crossing, and its range.
void fill(const KnownError& error, const std::vector<PunchRoom>& rooms, OpeningEstimate& opening) {
  const auto in = [&](std::size_t n, double offered, double factor) {
    return opening.is_cavity ? kept(opening, rooms[n], factor * offered, factor) : factor * offered;
  };
  double offered = 0;
  for (std::size_t n = 0; n < opening.offered.size(); ++n) {
    offered += opening.offered[n];
    opening.mass.push_back(in(n, offered, 1));
  }
  if (opening.mass.empty()) return;
  const std::size_t last = opening.mass.size() - 1;
  const double least = in(last, offered, 1 / error.factor), most = in(last, offered, error.factor);
  const double packing = opening.is_cavity ? error.packing : 0;
  opening.least_mass = least * (1 - packing);
  opening.most_mass = most * (1 + packing);
  if (!(opening.full_mass > 0)) return;
  opening.share = opening.mass.back() / opening.full_mass;
  opening.least_share = least / opening.full_mass;
  opening.most_share = most / opening.full_mass;
}

/// Powder that is poured over an open slit does not come to rest before it has run out. At least as much runs
/// through as the formula says of the time that powder is taken to need until at rest.
void run_out(double poured, OpeningEstimate& opening) {
  for (double& mass : opening.mass) mass = std::max(mass, poured);
  opening.most_mass = std::max(opening.most_mass, poured);
}

/// The largest factor on the shoe's speed at which the cavity still fills; nothing where even a hundredth of
/// it is too fast, or speed does not matter.
template <class Fills>
std::optional<double> fastest(const Fills& fills) {
  double slow = 0.01, fast = 100;
  if (!fills(slow) || fills(fast)) return std::nullopt;
  while (fast > 1.002 * slow) {
    const double middle = std::sqrt(slow * fast);
    (fills(middle) ? slow : fast) = middle;
  }
  return slow;
}

/// Whether the cavity is full after its first `crossings` with the shoe `faster` times as fast.
bool fills_at(const EstimateInputs& inputs, std::size_t k, const OpeningEstimate& opening,
              const PunchRoom& room, std::size_t crossings, double faster) {
  const double offered = sum(inflow_at(inputs.layout, inputs.path, inputs.powder, k, crossings, faster));
  return kept(opening, room, offered) >= kFull * opening.full_mass;
}

/// Crossings needed at the scene's speed.
std::optional<int> crossings_needed(const std::vector<PunchRoom>& rooms, const OpeningEstimate& opening) {
  if (rooms.back().made > 0)
    for (std::size_t n = 0; n < opening.mass.size(); ++n)
      if (opening.mass[n] >= kFull * opening.full_mass) return static_cast<int>(n) + 1;
  const double wanted =
      offered_for(space_of(opening), kFull * opening.depth) / opening.depth * opening.full_mass;
  const double once = sum(opening.offered) / static_cast<double>(opening.offered.size());
  if (!(once > 0) || wanted / once > kMaxCrossings) return std::nullopt;
  return std::max(1, static_cast<int>(std::ceil(wanted / once - 1e-9)));
}

void find_speeds(const EstimateInputs& inputs, std::size_t k, const std::vector<PunchRoom>& rooms,
                 OpeningEstimate& opening) {
  if (!opening.is_cavity || opening.offered.empty()) return;
  if (inputs.path.speed > 0 || rooms.back().made > 0) opening.crossings = crossings_needed(rooms, opening);
  if (!(inputs.path.speed > 0)) return;
  const auto fills = [&](std::size_t crossings) {
    return [&, crossings](double faster) {
      return fills_at(inputs, k, opening, rooms[crossings - 1], crossings, faster);
    };
  };
  const auto speed = [&](std::size_t crossings) -> std::optional<double> {
    const auto factor = fastest(fills(crossings));
    if (!factor) return std::nullopt;
    return *factor * inputs.path.speed;
  };
  opening.speed_once = speed(1);
  opening.speed_all = opening.offered.size() > 1 ? speed(opening.offered.size()) : opening.speed_once;
  opening.any_speed = !opening.speed_once && fills(1)(100);
}

/// The same for particles of the powder's own size, which the grains of the scene stand for.
void find_real_particles(const EstimateInputs& inputs, std::size_t k, const PowderEstimate& powder,
                         OpeningEstimate& opening) {
  if (!opening.is_cavity || opening.offered.empty() || !powder.particle_diameter ||
      *powder.particle_diameter > 0.99 * inputs.powder.grain_diameter)
    return;
  InflowPowder fine = inputs.powder;
  fine.grain_diameter = *powder.particle_diameter;
  const EstimateInputs own = {inputs.layout, inputs.path, fine};
  const auto rooms = punch_room(inputs.layout, inputs.path, fine, k);
  const auto offered = inflow_at(inputs.layout, inputs.path, fine, k, inputs.path.crossings, 1);
  opening.real_particle_share = kept(opening, rooms.back(), sum(offered)) / opening.full_mass;
  if (!(inputs.path.speed > 0)) return;
  const auto factor =
      fastest([&](double faster) { return fills_at(own, k, opening, rooms.front(), 1, faster); });
  if (factor) opening.real_particle_speed_once = *factor * inputs.path.speed;
}

/// Sets what is shared over the places of opening `k`: where the shoe is too fast, how long powder covers it.
void find_cover(const EstimateInputs& inputs, std::size_t k, OpeningEstimate& opening) {
  double area = 0, fast = 0, open = 0, longest = 0, poured = 0;
  for (std::size_t n = 0; n < inputs.layout.places.size(); ++n) {
    const OpeningPatch& place = inputs.layout.places[n];
    if (place.opening != k || inputs.path.exposures[n].empty()) continue;
    const Exposure& first = inputs.path.exposures[n].front();
    const Portions portions = portions_of(place, first, inputs.path, inputs.powder);
    area += place.area;
    opening.filling_time += place.area * first.seconds;
    if (inputs.path.open_during_pour(n)) poured += place.area;
    if (portions.width > 0) {
      open += place.area;
      longest += place.area * portions.longest();
    }
    if (!(portions.width > 0) ||
        portions.longest() < continuum::kBurst * std::sqrt(portions.width / inputs.powder.gravity))
      fast += place.area;
  }
  if (!(area > 0)) return;
  opening.filling_time /= area;
  opening.too_fast = fast / area;
  opening.poured = poured / opening.area;
  if (open > 0 && longest > 0 && inputs.path.speed > 0)
    opening.froude = std::sqrt(opening.effective_width / inputs.powder.gravity) / (longest / open);
}

double longest_x(const EstimateInputs& inputs, std::size_t k) {
  double longest = 0;
  for (std::size_t n = 0; n < inputs.layout.places.size(); ++n) {
    const OpeningPatch& place = inputs.layout.places[n];
    if (place.opening != k) continue;
    for (const Exposure& exposure : inputs.path.exposures[n]) {
      const Portions portions = portions_of(place, exposure, inputs.path, inputs.powder);
      if (portions.width > 0)
        longest = std::max(longest, portions.longest() * std::sqrt(inputs.powder.gravity / portions.width) -
                                        continuum::kBurst);
    }
  }
  return longest;
}

}  // namespace

OpeningEstimate opening_estimate(const EstimateInputs& inputs, std::size_t k, const PowderEstimate& powder,
                                 const KnownError& error) {
  const FillOpening& layout = inputs.layout.openings[k];
  OpeningEstimate opening;
  opening.is_cavity = layout.is_cavity;
  opening.centre = layout.centre;
  opening.volume = layout.volume;
  opening.area = layout.area;
  opening.depth = layout.area > 0 ? layout.volume / layout.area : 0;
  opening.width = layout.width;
  opening.narrowest = layout.narrowest;
  opening.effective_width = effective_width(layout.width, inputs.powder);
  opening.full_mass = powder.density * layout.volume;
  opening.offered = inflow_at(inputs.layout, inputs.path, inputs.powder, k, inputs.path.crossings, 1);
  opening.longest_x = longest_x(inputs, k);
  find_cover(inputs, k, opening);
  const bool by_pour = opening.is_cavity && opening.effective_width > 0 && opening.poured >= kWhole;
  const auto rooms = punch_room(inputs.layout, inputs.path, inputs.powder, k);
  if (opening.is_cavity) cap_by_room(rooms, opening);
  if (by_pour) {
    fill_by_pour(error, opening);
    return opening;
  }
  fill(error, rooms, opening);
  if (opening.runs_out()) run_out(powder.in_shoe, opening);
  find_speeds(inputs, k, rooms, opening);
  find_real_particles(inputs, k, powder, opening);
  if (opening.is_cavity && powder.carrying_flux)
    find_trapped_air(inputs.layout, inputs.path, k, *powder.carrying_flux, opening);
  return opening;
}

}  // namespace diefill::process::estimate
