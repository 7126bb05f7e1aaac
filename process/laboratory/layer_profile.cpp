#include "process/laboratory/layer_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::process::laboratory {

LayerProfile layer_profile(const results::PowderState& powder, double area) {
  const double d = powder.grain_diameter, radius = powder.sphere_radius;
  const auto centres = powder.sphere_centres();
  double top = 0;
  for (const auto& centre : centres) top = std::max(top, centre[2]);
  LayerProfile profile;
  for (double z = 0; z < top - 2 * d; z += d / 20) {
    double solid = 0;
    for (const auto& centre : centres) {
      const double away = centre[2] - z;
      solid += std::numbers::pi * std::max(0.0, radius * radius - away * away);
    }
    profile.height.push_back(z / d);
    profile.share.push_back(solid / area);
  }
  return profile;
}

NearGround near_ground(const LayerProfile& profile, double bulk) {
  constexpr double kReach = 2;  // d
  constexpr double kWithin = 0.1;
  const auto near = static_cast<std::size_t>(
      std::lower_bound(profile.height.begin(), profile.height.end(), kReach) - profile.height.begin());
  // The final drop is where the profile only falls towards the ground: it ends at the first maximum.
  std::size_t first = 1;
  while (first + 1 < near && profile.share[first + 1] >= profile.share[first]) ++first;
  NearGround found{1, 0};
  for (std::size_t k = first; k < near; ++k) {
    found.lowest_share = std::min(found.lowest_share, profile.share[k]);
    if (std::abs(profile.share[k] / bulk - 1) > kWithin) found.bulk_reached_at = profile.height[k];
  }
  return found;
}

}  // namespace diefill::process::laboratory
