#include "process/run/suction.h"

#include "process/run/material.h"
#include "process/scene/scene_error.h"

namespace diefill::process {

double permeability(double diameter, double solid_fraction) {
  constexpr double kCarman = 180;
  const double pores = 1 - solid_fraction;
  return diameter * diameter * pores * pores * pores / (kCarman * solid_fraction * solid_fraction);
}

std::optional<engine::AirDraught> draught_of(const Scene& scene, const Tooling& tooling,
                                             const engine::GrainShape& shape) {
  if (!scene.suction) return std::nullopt;
  const SuctionSpec& suction = *scene.suction;
  if (!tooling.cavity.found)
    throw SceneError(
        scene.file.string() +
        ": [suction]: the tools enclose no cavity that air could be drawn into; leave the table out");
  const double fraction =
      suction.solid_fraction > 0 ? suction.solid_fraction : expected_solid_fraction(scene);
  engine::AirDraught draught;
  draught.body = tooling.index_of(suction.tool);
  draught.region = {tooling.cavity.box.lower, tooling.cavity.box.upper};
  draught.resistance =
      suction.viscosity / permeability(suction.particle_diameter, fraction) * shape.solid_volume / fraction;
  return draught;
}

}  // namespace diefill::process
