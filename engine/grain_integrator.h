// Carries grains through a time step, many at a time: positions and orientations to its end, velocities from
// the forces found there (Bierwisch 2009, section 2.2). Composed grains here, single spheres in
// sphere_integrator.h.
#pragma once

#include <optional>
#include <span>

#include "engine/grain_kinds.h"
#include "engine/grains.h"
#include "engine/sphere_field.h"
#include "engine/sphere_integrator.h"
#include "engine/vector_instructions.h"

namespace diefill::engine {

/// Works on runs of grains, so that threads can share them. SI units.
class GrainIntegrator {
 public:
  /// `air_viscosity` in Pa s, Stokes drag on every sphere (Bierwisch 2009, Eq. 2.9). `rolls`: whether
  /// contacts' rolling loads count, which they can for single spheres only.
  GrainIntegrator(const KindTable& kinds, const Eigen::Vector3d& gravity, double air_viscosity, bool rolls,
                  double time_step, InstructionSet instructions);

  /// Takes grains [begin, end) to the end of the step and places their spheres, with the velocities that the
  /// present forces would lead to: forces depend on velocities (OP-3).
  void advance(Grains& grains, std::size_t begin, std::size_t end, SphereField& spheres) const;

  /// Ends the step of grains [begin, end), given the contacts' forces (N) on each and their moments (N m,
  /// laboratory frame) about its centre.
  StepWork finish(Grains& grains, std::size_t begin, std::size_t end,
                  std::span<const ContactSum> contacts) const;

 private:
  /// What the motion of one kind depends on.
  struct Body {
    double mass;           ///< kg
    double drag;           ///< kg/s, Stokes drag on all spheres over the speed
    Vector3 inertia;       ///< kg m^2
    Vector3 weight;        ///< N
    Vector3 turning_drag;  ///< kg m^2/s, about the axes of the body frame
  };
  struct AlikeBodies;
  struct BodyLanes;

  static Body body_of(const GrainShape& shape, const Eigen::Vector3d& gravity, double air_viscosity);
  template <class Bodies>
  void advance_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                    SphereField& spheres) const;
  template <class Bodies>
  StepWork finish_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                       std::span<const ContactSum> contacts) const;

  std::vector<Body> bodies_;                ///< one a kind
  std::optional<SphereIntegrator> single_;  ///< where grains are single spheres
  bool rotates_;
  double time_step_;
  InstructionSet instructions_;
};

}  // namespace diefill::engine
