#include "process/run/suction.h"

#include <cstdio>

#include "engine/simulation/settings.h"
#include "process/input/scene_error.h"
#include "process/powder/material.h"

namespace diefill::process {
namespace {

/// Share of the air's speed that a grain may take on in one step: well below 2, at which its oscillation
/// grows.
constexpr double kMaxTakenAlong = 0.2;

[[noreturn]] void refuse_fine_particles(const Scene& scene, double taken_along) {
  char text[240];
  std::snprintf(
      text, sizeof text,
      ": suction.particle_diameter: found %.3g mm: air barely passes such fine powder, and grains would take "
      "on %.2g of its speed in one time step, allowed: at most %.2g; make it larger or the time step "
      "shorter",
      1e3 * scene.suction->particle_diameter, taken_along, kMaxTakenAlong);
  throw SceneError(scene.file.string() + text);
}

}  // namespace

double permeability(double diameter, double solid_fraction) {
  constexpr double kCarman = 180;
  const double pores = 1 - solid_fraction;
  return diameter * diameter * pores * pores * pores / (kCarman * solid_fraction * solid_fraction);
}

std::optional<engine::AirFlow> air_flow_of(const Scene& scene, const Tooling& tooling,
                                           const engine::SimulationSettings& settings) {
  if (!scene.suction) return std::nullopt;
  const SuctionSpec& suction = *scene.suction;
  if (!tooling.cavity.found)
    throw SceneError(scene.file.string() +
                     ": [suction]: the tools enclose no cavity to draw air into; remove the table");
  if (!tooling.other_cavities.empty())
    throw SceneError(scene.file.string() + ": [suction]: the tools enclose " +
                     std::to_string(tooling.other_cavities.size() + 1) +
                     " cavities, but suction supports only one; remove the table");
  const double fraction =
      suction.solid_fraction > 0 ? suction.solid_fraction : expected_solid_fraction(scene);
  engine::AirFlow flow;
  flow.body = tooling.index_of(suction.tool);
  flow.region = {tooling.cavity.box.lower, tooling.cavity.box.upper};
  for (const auto& type : settings.types) {
    flow.resistance.push_back(suction.viscosity / permeability(suction.particle_diameter, fraction) *
                              type.shape.solid_volume / fraction);
    const double taken_along = flow.resistance.back() * settings.time_step / type.shape.mass;
    if (taken_along > kMaxTakenAlong) refuse_fine_particles(scene, taken_along);
  }
  return flow;
}

}  // namespace diefill::process
