#include "process/tooling/rest.h"

#include "engine/observe/powder_figures.h"
#include "engine/simulation/simulation.h"

namespace diefill::process {

namespace {

constexpr double kStillDistance = 1e-3;  // of d
constexpr double kStillTime = 0.1;       // s

Eigen::Vector3d centre_of_mass(const engine::Grains& grains) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& position : grains.position) sum += position;
  return sum / static_cast<double>(grains.size());
}

/// kg.
double mean_mass(const engine::Simulation& simulation) {
  if (simulation.types().monodisperse()) return simulation.settings().shape().mass;
  const std::size_t grains = simulation.grains().size();
  return engine::powder_mass(simulation) / static_cast<double>(grains);
}

/// J per grain.
double kinetic_energy(const engine::Simulation& simulation) {
  const engine::Grains& grains = simulation.grains();
  double sum = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const engine::GrainShape& shape = simulation.shape_of(k);
    sum += 0.5 * shape.mass * grains.velocity[k].squaredNorm();
    if (shape.rotates) sum += 0.5 * shape.inertia.dot(grains.spin[k].cwiseAbs2());
  }
  return sum / static_cast<double>(grains.size());
}

}  // namespace

bool RestWatch::at_rest(const engine::Simulation& simulation, double grain_diameter,
                        const std::optional<RestLimits>& limits) {
  if (simulation.grains().size() == 0) return true;
  const double now = simulation.time();
  const auto& settings = simulation.settings();
  const RestLimits quiet = limits.value_or(RestLimits{});
  const double limit = quiet.energy * mean_mass(simulation) * settings.gravity.norm() * grain_diameter;
  if (kinetic_energy(simulation) > limit)
    quiet_since = -1;
  else if (quiet_since < 0)
    quiet_since = now;
  if (quiet_since >= 0 && now - quiet_since >= quiet.time) return true;
  if (limits) return false;

  const Eigen::Vector3d centre = centre_of_mass(simulation.grains());
  if (still_since < 0 || (centre - place).norm() > kStillDistance * grain_diameter) {
    still_since = now;
    place = centre;
  }
  return now - still_since >= kStillTime;
}

}  // namespace diefill::process
