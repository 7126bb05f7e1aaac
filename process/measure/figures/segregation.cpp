#include "process/measure/figures/segregation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/figures.h"
#include "process/measure/weights.h"
#include "process/results/none.h"

namespace diefill::process {
namespace {

constexpr std::size_t kMinOfASample = 3;
constexpr double kSectors = 12;

/// Sums of one bin, or of all.
struct Sums {
  double weight = 0, moment = 0, squares = 0;  // squares: of the weights
  std::size_t grains = 0;

  void add(double value, double with) {
    weight += with;
    moment += with * value;
    squares += with * with;
    ++grains;
  }
  double mean() const { return weight > 0 ? moment / weight : kNone; }
};

std::vector<std::size_t> filled_grains(const results::FillResult& result) {
  std::vector<std::size_t> grains;
  if (result.powder.monodisperse() || !(result.cavity.volume > 0)) return grains;
  for (std::size_t k = 0; k < result.solid_fraction.in_cavity.size(); ++k)
    if (result.solid_fraction.in_cavity[k] != 0) grains.push_back(k);
  return grains;
}

/// Equal bins along one coordinate of the cavity.
struct Bins {
  std::string x_name, x_unit;
  double length = 0;  ///< in x_unit
  std::size_t count = 1;
  std::function<double(const Eigen::Vector3d&)> place;  ///< 0 to 1

  std::size_t of(const Eigen::Vector3d& point) const {
    const double at = std::clamp(place(point), 0.0, 1.0) * static_cast<double>(count);
    return std::min(static_cast<std::size_t>(at), count - 1);
  }
};

/// Bins two of the largest grains high, as many as the cavity has room for.
Bins over_height(const results::FillResult& result) {
  constexpr double kMax = 12, kMin = 2;
  const double floor = result.cavity.lower_corner.z(), depth = result.cavity.upper_corner.z() - floor;
  const double count = std::clamp(std::floor(depth / (2 * result.powder.largest_diameter())), kMin, kMax);
  return {"height", "mm", 1e3 * depth, static_cast<std::size_t>(count),
          [floor, depth](const Eigen::Vector3d& point) { return (point.z() - floor) / depth; }};
}

/// Sectors of a ring; slices along the travel of the shoe elsewhere.
Bins across(const results::FillResult& result) {
  const results::CavityState& cavity = result.cavity;
  if (cavity.is_ring)
    return {"azimuth", "deg", 360, static_cast<std::size_t>(kSectors),
            [cavity](const Eigen::Vector3d& point) { return ring_position(cavity, point).azimuth / 360; }};
  constexpr double kMin = 2;
  const double length = travel_length(cavity);
  const double count =
      std::clamp(std::floor(length / (2 * result.powder.largest_diameter())), kMin, kSectors);
  return {"travel", "mm", 1e3 * length, static_cast<std::size_t>(count),
          [cavity](const Eigen::Vector3d& point) { return along_travel(cavity, point); }};
}

results::Profile profile_over(const results::FillResult& result, const std::vector<std::size_t>& grains,
                              const Bins& bins) {
  results::Profile profile{"mean grain diameter", "mm", bins.x_name, bins.x_unit, {}, {}};
  std::vector<Sums> sums(bins.count);
  const auto& powder = result.powder;
  for (const std::size_t k : grains)
    sums[bins.of(powder.position[k])].add(1e3 * powder.diameter_of(k), powder.mass_of(k));
  for (std::size_t n = 0; n < bins.count; ++n) {
    profile.x.push_back((static_cast<double>(n) + 0.5) * bins.length / static_cast<double>(bins.count));
    profile.y.push_back(sums[n].grains >= kMinOfASample ? sums[n].mean() : kNone);
  }
  return profile;
}

/// `value`: of grain k.
double index_over(const results::FillResult& result, const std::vector<std::size_t>& grains, const Bins& bins,
                  const std::function<double(std::size_t)>& value) {
  std::vector<double> values, weights;
  std::vector<std::size_t> numbers;
  for (const std::size_t k : grains) {
    values.push_back(value(k));
    weights.push_back(result.powder.mass_of(k));
    numbers.push_back(bins.of(result.powder.position[k]));
  }
  return mixing_index(values, weights, numbers);
}

/// mm, mean diameter by mass.
double mean_diameter(const results::PowderState& powder, const std::vector<std::size_t>& grains) {
  Sums sums;
  for (const std::size_t k : grains) sums.add(1e3 * powder.diameter_of(k), powder.mass_of(k));
  return sums.mean();
}

/// Upper less lower third of the filled grains by height, each the third of them that lies there.
double top_minus_bottom(const results::PowderState& powder, std::vector<std::size_t> grains) {
  const std::size_t third = grains.size() / 3;
  if (third < kMinOfASample) return kNone;
  std::sort(grains.begin(), grains.end(), [&](std::size_t a, std::size_t b) {
    const double low = powder.position[a].z(), high = powder.position[b].z();
    return low != high ? low < high : a < b;
  });
  const auto from = grains.begin(), to = grains.end();
  const auto count = static_cast<std::ptrdiff_t>(third);
  return mean_diameter(powder, {to - count, to}) - mean_diameter(powder, {from, from + count});
}

std::vector<double> by_grain(const results::PowderState& powder, bool with_diameter) {
  if (powder.monodisperse())
    throw std::invalid_argument("all grains have one size, so there is no mean diameter to show");
  std::vector<double> values;
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    values.push_back(powder.mass_of(k) * (with_diameter ? 1e3 * powder.diameter_of(k) : 1));
  return values;
}

GaussianField field_of(const results::PowderState& powder, bool with_diameter, double averaging_width) {
  return GaussianField::of_all_grains(powder.position, by_grain(powder, with_diameter), powder.grain_diameter,
                                      averaging_width, period_of(powder));
}

}  // namespace

std::vector<results::Profile> size_profiles(const results::FillResult& result) {
  const auto grains = filled_grains(result);
  if (grains.empty()) return {};
  std::vector<results::Profile> profiles = {profile_over(result, grains, over_height(result))};
  profiles.push_back(profile_over(result, grains, across(result)));
  return profiles;
}

SizeField::SizeField(const results::PowderState& powder, double averaging_width)
    : moment_(field_of(powder, true, averaging_width)), mass_(field_of(powder, false, averaging_width)) {}

double SizeField::at(const Eigen::Vector3d& point) const {
  return moment_.at(point) / mass_.at(point);
}

double mixing_index(const std::vector<double>& values, const std::vector<double>& weights,
                    const std::vector<std::size_t>& bins) {
  std::vector<Sums> sums(bins.empty() ? 0 : *std::max_element(bins.begin(), bins.end()) + 1);
  Sums all;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sums[bins[k]].add(values[k], weights[k]);
    all.add(values[k], weights[k]);
  }
  const double mean = all.mean();
  double separated = 0, between = 0, chance = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    separated += weights[k] * std::pow(values[k] - mean, 2) / all.weight;
  std::size_t with_grains = 0;
  for (const Sums& bin : sums) {
    if (bin.grains == 0) continue;
    ++with_grains;
    between += bin.weight * std::pow(bin.mean() - mean, 2) / all.weight;
    // Of a mean of grains drawn with these weights.
    chance += bin.weight / all.weight * separated * bin.squares / (bin.weight * bin.weight);
  }
  if (with_grains < 2 || !(separated > chance)) return kNone;
  return (separated - between) / (separated - chance);
}

void size_segregation(const results::FillResult& result, Figures& figures) {
  const auto grains = filled_grains(result);
  if (grains.empty()) return;
  const auto& powder = result.powder;
  std::vector<std::size_t> all(powder.position.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  figures["mean_grain_diameter_filled_mm"] = mean_diameter(powder, grains);
  figures["mean_grain_diameter_all_mm"] = mean_diameter(powder, all);
  figures["mean_grain_diameter_top_minus_bottom_mm"] = top_minus_bottom(powder, grains);
  const Bins sideways = across(result);
  const auto size = [&](std::size_t k) { return powder.diameter_of(k); };
  figures["mixing_index_height"] = index_over(result, grains, over_height(result), size);
  figures["mixing_index_" + sideways.x_name] = index_over(result, grains, sideways, size);
}

void powder_segregation(const results::FillResult& result, Figures& figures) {
  const auto grains = filled_grains(result);
  const auto& powder = result.powder;
  const auto& materials = powder.kinds.material;
  if (grains.empty() || std::ranges::all_of(materials, [&](const auto& one) { return one == materials[0]; }))
    return;
  const auto is_first = [&](std::size_t k) { return materials[powder.kind[k]] == materials[0] ? 1.0 : 0.0; };
  Sums filled, all;
  for (const std::size_t k : grains) filled.add(is_first(k), powder.mass_of(k));
  for (std::size_t k = 0; k < powder.position.size(); ++k) all.add(is_first(k), powder.mass_of(k));
  figures["first_powder_mass_share_filled"] = filled.mean();
  figures["first_powder_mass_share_all"] = all.mean();
  const Bins sideways = across(result);
  figures["powder_mixing_index_height"] = index_over(result, grains, over_height(result), is_first);
  figures["powder_mixing_index_" + sideways.x_name] = index_over(result, grains, sideways, is_first);
}

}  // namespace diefill::process
