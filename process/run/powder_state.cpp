#include "process/run/powder_state.h"

#include "engine/observe/contact_stress.h"
#include "engine/simulation/simulation.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"

namespace diefill::process {

namespace {

/// The kinds of `simulation` and the kind of every grain, where they are not all alike.
void add_kinds(const Scene& scene, const engine::Simulation& simulation, results::PowderState& powder) {
  const engine::ParticleTypes& kinds = simulation.types();
  if (kinds.monodisperse()) return;
  powder.kinds.diameter = grain_diameters(scene);
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    powder.kinds.material.resize(types_of_powder(scene, k).last, powder_of(scene, k).label);
  const bool one_shape = scene.other_powders.empty();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const engine::GrainShape& shape = kinds.shape(static_cast<engine::TypeNumber>(k));
    powder.kinds.sphere_radius.push_back(shape.sphere_radius);
    powder.kinds.mass.push_back(shape.mass);
    powder.kinds.solid_volume.push_back(shape.solid_volume);
    if (one_shape) continue;
    powder.kinds.spheres.push_back(static_cast<std::uint32_t>(shape.spheres()));
    for (std::size_t s = 0; s < shape.spheres(); ++s) {
      powder.kinds.sphere_offsets.push_back(shape.sphere_offsets[s]);
      powder.kinds.sphere_radii.push_back(shape.radius_of(s));
    }
  }
  powder.kind.assign(simulation.grains().kind.begin(), simulation.grains().kind.end());
}

}  // namespace

results::PowderState powder_state(const engine::Simulation& simulation, const engine::GrainShape& shape,
                                  double grain_diameter) {
  const engine::Grains& grains = simulation.grains();
  results::PowderState powder;
  powder.time = simulation.time();
  powder.grain_diameter = grain_diameter;
  powder.sphere_radius = shape.sphere_radius;
  powder.grain_mass = shape.mass;
  powder.grain_solid_volume = shape.solid_volume;
  powder.sphere_offsets = shape.sphere_offsets;
  powder.sphere_radii = shape.sphere_radii;
  for (std::size_t axis = 0; axis < 3; ++axis)
    powder.period[axis] = simulation.settings().period[axis].value_or(0);
  powder.id = grains.id;
  powder.position = grains.position;
  powder.orientation = grains.orientations();
  powder.velocity = grains.velocity;
  for (std::size_t k = 0; k < grains.size(); ++k)
    powder.angular_velocity.push_back(simulation.angular_velocity(k));
  return powder;
}

results::PowderState powder_state(const Scene& scene, const engine::Simulation& simulation) {
  results::PowderState powder = powder_state(simulation, mean_grain(scene), scene.powder.grain_diameter);
  add_kinds(scene, simulation, powder);
  return powder;
}

results::ContactStress contact_stress(const engine::Simulation& simulation, const DieFrame& die) {
  results::ContactStress stress;
  for (const Eigen::Matrix3d& laboratory : engine::contact_stress_times_volume(simulation)) {
    const Eigen::Matrix3d tensor = die.at_initial_pose() ? laboratory : die.tensor(laboratory);
    const Eigen::Matrix3d even = 0.5 * (tensor + tensor.transpose());
    stress.normal.emplace_back(even.diagonal());
    stress.shear.emplace_back(even(1, 2), even(0, 2), even(0, 1));
  }
  return stress;
}

}  // namespace diefill::process
