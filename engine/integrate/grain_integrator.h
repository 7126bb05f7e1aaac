// Moves grains through a time step, many at a time: positions and orientations to its end, velocities from
// the forces there (Bierwisch 2009, section 2.2). Clumps are moved here, single spheres in
// sphere_integrator.h.
#pragma once

#include <optional>

#include "engine/integrate/sphere_integrator.h"
#include "engine/numerics/vector_instructions.h"
#include "engine/powder/grains.h"
#include "engine/powder/particle_types.h"
#include "engine/powder/sphere_field.h"
#include "engine/search/contact_sums.h"

namespace diefill::engine {

/// Works on ranges of grains, so that threads can share them. SI units.
class GrainIntegrator {
 public:
  /// `air_viscosity` in Pa s, Stokes drag on every sphere (Bierwisch 2009, Eq. 2.9). `rolls`: whether
  /// contacts' rolling loads count, which they can for single spheres only.
  GrainIntegrator(const ParticleTypes& types, const Eigen::Vector3d& gravity, double air_viscosity,
                  bool rolls, double time_step, InstructionSet instructions);

  /// Moves grains [begin, end) to the end of the step and places their spheres, with the velocities that the
  /// present forces predict: forces depend on velocities (OP-3).
  /// Returns how far (m) any of their spheres can have moved in the step relative to powder that drifted by
  /// `drifted` (m); rounding may make it less.
  double advance(Grains& grains, std::size_t begin, std::size_t end, const Vector3& drifted,
                 SphereField& spheres) const;

  /// Ends the step of grains [begin, end), given the contacts' forces (N) on each and their moments (N m,
  /// laboratory frame) about its centre: sum `first_sum` is that of grain `begin`.
  StepWork finish(Grains& grains, std::size_t begin, std::size_t end, const ContactSums& contacts,
                  std::size_t first_sum) const;

 private:
  /// Motion constants of one particle type.
  struct Body {
    double mass;           ///< kg
    double drag;           ///< kg/s, Stokes drag on all spheres over the speed
    Vector3 inertia;       ///< kg m^2
    Vector3 weight;        ///< N
    Vector3 turning_drag;  ///< kg m^2/s, about the axes of the body frame
  };
  struct EqualBodies;
  struct BodyLanes;

  static Body body_of(const GrainShape& shape, const Eigen::Vector3d& gravity, double air_viscosity);
  template <class Bodies>
  double advance_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                      const Vector3& drifted, SphereField& spheres) const;
  template <class Bodies>
  StepWork finish_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                       const ContactSums& contacts, std::size_t first_sum) const;

  std::vector<Body> bodies_;                ///< one a particle type
  std::optional<SphereIntegrator> single_;  ///< where grains are single spheres
  bool rotates_;
  double displacement_per_turn_;  ///< m, that spheres go at most over the change of their grain's quaternion
  double time_step_;
  InstructionSet instructions_;
};

}  // namespace diefill::engine
