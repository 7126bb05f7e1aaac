#include "process/measured_data/profile_names.h"

#include <cmath>

#include "process/measured_data/known_fields.h"

namespace diefill::process {

std::vector<std::string> names_of(const results::Profile& profile) {
  std::vector<std::string> names = {profile.quantity, profile.quantity + " over " + profile.x_name};
  if (runs_along_travel(profile))
    for (const char* axis : {"x", "y"}) names.push_back(profile.quantity + " over " + axis);
  return names;
}

bool runs_along_travel(const results::Profile& profile) {
  return same_name(profile.x_name, "distance along the shoe's travel");
}

std::optional<double> distance_along_travel(const std::string& place, double position,
                                            const results::CavityState& cavity) {
  const bool travels_in_x = std::abs(cavity.azimuth_zero.x()) >= std::abs(cavity.azimuth_zero.y());
  if (!same_name(place, travels_in_x ? "x" : "y")) return std::nullopt;
  const Eigen::Index axis = travels_in_x ? 0 : 1;
  // The shoe arrives at the end towards which azimuth zero points.
  return cavity.azimuth_zero[axis] > 0 ? cavity.upper_corner[axis] - position
                                       : position - cavity.lower_corner[axis];
}

}  // namespace diefill::process
