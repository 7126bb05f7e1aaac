#include "process/estimate/powder_estimate.h"

#include <algorithm>
#include <limits>

#include "process/continuum/air.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/powder/material.h"
#include "process/run/suction.h"
#include "process/scene/powder/powder_presets.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

/// kg/m^3, of the real particles.
double solid_density(const Scene& scene) {
  const double metal = preset_solid_density(scene.powder);
  if (metal > 0) return metal;
  const auto shape = mean_grain(scene);
  return shape.mass / shape.solid_volume;
}

void choose_particles(const Scene& scene, const EstimateOptions& options, PowderEstimate& powder) {
  constexpr double kPublished = 1e-4;  // m (Bierwisch 2009, section 4.1.3)
  if (options.particle_diameter) {
    powder.particle_diameter = options.particle_diameter;
    powder.particle_source = "as given";
  } else if (scene.suction) {
    powder.particle_diameter = scene.suction->particle_diameter;
    powder.particle_source = "from [suction]";
  } else if (preset_solid_density(scene.powder) > 0) {
    powder.particle_diameter = kPublished;
    powder.particle_source = "about that of ASC100.29 (Bierwisch 2009, section 4.1.3)";
  }
  powder.air_viscosity = scene.suction ? scene.suction->viscosity : continuum::kAirViscosity;
}

/// kg that steps let in; infinite where they follow what runs off.
double let_in(const Scene& scene) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  double mass = 0;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const PowderInflow* inflow = stages.steps[k]->inflow();
    if (inflow == nullptr) continue;
    const double by_rate = inflow->rate ? *inflow->rate * std::max(0.0, states[k].ended - states[k].started)
                                        : std::numeric_limits<double>::infinity();
    const auto& until = stages.steps[k]->plan.until;
    const bool known_end = until && !until->measures();
    mass += inflow->mass ? (known_end ? std::min(*inflow->mass, by_rate) : *inflow->mass) : by_rate;
  }
  return mass;
}

void find_amounts(const Scene& scene, const Tooling& tooling, PowderEstimate& powder) {
  const Eigen::Vector3d box = scene.pour.upper - scene.pour.lower;
  const double halves = tooling.mirror ? 2 : 1;
  powder.in_shoe = powder.density * box.x() * box.y() * scene.pour.fill_height * halves;
  powder.let_in = let_in(scene);
  powder.depth = scene.pour.fill_height;
  if (powder.let_in > 0) powder.depth *= 1 + powder.let_in / powder.in_shoe;
}

}  // namespace

PowderEstimate powder_estimate(const Scene& scene, const Tooling& tooling, const EstimateOptions& options) {
  PowderEstimate powder;
  powder.solid_fraction = expected_solid_fraction(scene);
  powder.density_is_estimate = !(scene.powder.apparent_density > 0);
  powder.density = powder.density_is_estimate ? powder.solid_fraction * solid_density(scene)
                                              : scene.powder.apparent_density;
  find_amounts(scene, tooling, powder);
  powder.name = scene.powder.label;
  for (const OtherPowder& other : scene.other_powders)
    powder.left_out += (powder.left_out.empty() ? "" : ", ") + other.powder.label;
  choose_particles(scene, options, powder);
  if (!powder.particle_diameter) return powder;
  powder.air_number =
      continuum::air_number(*powder.particle_diameter, solid_density(scene), powder.air_viscosity);
  // Of the real powder: as loosely as its apparent density says.
  const double fraction = std::min(0.74, powder.density / solid_density(scene));
  powder.carrying_flux = continuum::carrying_flux(permeability(*powder.particle_diameter, fraction),
                                                  powder.density, powder.air_viscosity, scene.gravity.norm());
  return powder;
}

}  // namespace diefill::process::estimate
