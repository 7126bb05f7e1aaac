#include "engine/contact/air_flow.h"

namespace diefill::engine {

double AirFlow::add_forces(const SphereField& grains, std::size_t begin, std::size_t end, double speed,
                           ContactSums& contacts) const {
  double power = 0;
  for (std::size_t grain = begin; grain < end; ++grain) {
    if (!region.contains(eigen(grains.grain_centre(grain)))) continue;
    const double predicted = grains.motion(grain).velocity.z;
    const double force = resistance[grains.kind.empty() ? 0 : grains.kind[grain]] * (speed - predicted);
    contacts.add_force(grain - begin, {0, 0, force});
    power += force * predicted;
  }
  return power;
}

}  // namespace diefill::engine
