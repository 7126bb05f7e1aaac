#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/measure.h"

namespace diefill::process {

results::Profile sector_filling(const results::PowderState& powder,
                                const results::GrainSolidFraction& fraction,
                                const results::CavityState& cavity, int sectors) {
  if (!cavity.is_ring || !(cavity.volume > 0)) throw std::invalid_argument("filling by sectors needs a ring");
  if (sectors < 1) throw std::invalid_argument("filling by sectors needs at least one sector");
  results::Profile filling{"filled fraction", "", "azimuth", "deg", {}, {}};
  for (int sector = 0; sector < sectors; ++sector) filling.x.push_back((sector + 0.5) * 360 / sectors);
  filling.y.assign(filling.x.size(), 0);
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (fraction.in_cavity[k] == 0) continue;
    const double azimuth = ring_position(cavity, powder.position[k]).azimuth;
    const int sector = std::min(static_cast<int>(azimuth / 360 * sectors), sectors - 1);
    filling.y[static_cast<std::size_t>(sector)] += powder.solid_volume_of(k) * sectors / cavity.volume;
  }
  return filling;
}

results::Profile height_profile(const results::Field2D& map) {
  results::Profile profile{map.quantity, "", map.second_name, map.second_unit, map.second, {}};
  const std::size_t row = map.first.size();
  const bool closes = row > 1 && map.first_unit == "deg" && map.first.back() - map.first.front() >= 360;
  const std::size_t nodes = closes ? row - 1 : row;
  for (std::size_t j = 0; j < map.second.size(); ++j) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double value = map.value[j * row + i];
      if (!std::isfinite(value)) continue;
      sum += value;
      ++count;
    }
    const bool enough = count > 0 && 2 * count >= nodes;
    profile.y.push_back(enough ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN());
  }
  return profile;
}

double relative_range(const results::Profile& profile) {
  double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
  int count = 0;
  for (const double value : profile.y) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
    sum += value;
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : (most - least) / (sum / count);
}

}  // namespace diefill::process
