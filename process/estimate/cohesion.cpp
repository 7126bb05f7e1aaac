#include "process/estimate/cohesion.h"

#include <algorithm>
#include <numbers>

#include "engine/contact/pair_laws.h"
#include "engine/limits/law_probe.h"
#include "process/powder/material.h"

namespace diefill::process::estimate {

namespace {

/// N, between two grains of the scene's size.
double largest_pull(const Scene& scene, const engine::ParticleTypes& types) {
  constexpr double kAnyStep = 1e-6;  // s, which matters to rolling only
  const engine::LawProbe probe(
      engine::law_between(types, contact_laws(scene, kAnyStep), types.class_of(0, 0), types.class_of(0, 0)));
  const double radius = types.classes()[types.class_of(0, 0)].radius;
  double pull = probe.pull_at_touch();
  for (const double overlap : {1e-9, 1e-6, 1e-4, 1e-3})
    pull = std::max(pull, -probe.loading_force(overlap * radius));
  return std::max(0.0, pull);
}

}  // namespace

double bond_number(const Scene& scene) {
  const PowderSpec& powder = scene.powder;
  const double gravity = scene.gravity.norm();
  if (!(gravity > 0)) return 0;
  if (!scene.contact) {
    const double effective = powder.sphere_radius / 2;
    return 1.5 * std::numbers::pi * powder.work_of_adhesion * effective / (powder.grain_mass * gravity);
  }
  const engine::ParticleTypes types(particle_types(scene));
  return largest_pull(scene, types) * coarse_graining_factor(powder) / (types.shape(0).mass * gravity);
}

}  // namespace diefill::process::estimate
