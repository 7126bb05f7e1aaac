#include "process/estimate/suction_estimate.h"

#include <algorithm>

#include "process/continuum/air.h"
#include "process/estimate/openings/punch_room.h"
#include "process/estimate/openings/shoe_poses.h"

namespace diefill::process::estimate {

namespace {

/// Over the width of an opening: coarser grains at rest above it may form an arch. Without shaking they do
/// over the narrow ring, 3.3 grains wide (Bierwisch 2009, section 6.5.3), and over one of 2.6
/// (sample_tools/README.md).
constexpr double kMayArch = 0.25;

}  // namespace

SuctionEstimate suction_estimate(const Scene& scene, const EstimateInputs& inputs, std::size_t k,
                                 const PowderEstimate& powder) {
  const FallingPunch& punch = inputs.layout.punches[k];
  SuctionEstimate suction;
  suction.punch = punch;
  suction.volume_mass = powder.density * punch.area * punch.stroke;
  suction.covered = covered_share(inputs.layout, inputs.path, k);
  const double room = suction.volume_mass * suction.covered;
  const double opening = inputs.layout.openings[punch.opening].width;
  const double own = running_speed(inputs.powder, effective_width(opening, inputs.powder));
  suction.by_weight = room * std::min(1.0, own / punch.speed());
  if (powder.carrying_flux) {
    suction.with_air =
        room * continuum::suction_speed(own, punch.speed(), *powder.carrying_flux) / punch.speed();
    suction.pull = punch.speed() / *powder.carrying_flux;
  }
  const bool air_breaks_it = scene.suction && suction.pull && *suction.pull > 1;
  suction.may_arch = suction.covered > 0 && inputs.powder.grain_diameter > kMayArch * opening &&
                     !air_breaks_it && !is_shaken(scene, inputs.path.tool, punch.began, punch.ended);
  return suction;
}

}  // namespace diefill::process::estimate
