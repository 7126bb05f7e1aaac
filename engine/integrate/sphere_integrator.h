// Moves single spheres through a time step. Their vectors lie one after the other in plain arrays, and all
// three components are treated the same, so arrays are processed as they lie: no number has to be moved to a
// lane.
#pragma once

#include <vector>

#include "engine/numerics/vector_instructions.h"
#include "engine/powder/grains.h"
#include "engine/powder/particle_types.h"
#include "engine/search/contact_sums.h"

namespace diefill::engine {

/// Work (J) done on grains in a step besides that of contacts and weight.
struct StepWork {
  double drag = 0, rolling = 0;
};

/// Velocity Verlet for centres and spins (Bierwisch 2009, section 2.2); the orientation of a sphere is not
/// stored. SI units.
class SphereIntegrator {
 public:
  /// Motion constants of one particle type.
  struct Body {
    double mass;     ///< kg
    double drag;     ///< kg/s, Stokes drag over the speed
    double inertia;  ///< kg m^2
    Vector3 weight;  ///< N
  };
  /// `rolls`: whether contacts' rolling loads count.
  SphereIntegrator(std::vector<Body> bodies, bool rotates, bool rolls, double time_step,
                   InstructionSet instructions);

  /// As GrainIntegrator::advance() and finish(). In between, velocities and spins of `grains` are those
  /// predicted for the end of the step, so a step needs no further memory.
  double advance(Grains& grains, std::size_t begin, std::size_t end, const Vector3& drifted) const;
  StepWork finish(Grains& grains, std::size_t begin, std::size_t end, const ContactSums& contacts,
                  std::size_t first_sum) const;

 private:
  static constexpr std::size_t kSpheres = 8;             ///< worked on at a time
  static constexpr std::size_t kNumbers = 3 * kSpheres;  ///< of their vectors: whole vector registers

  /// Factors for the numbers of a few spheres, one entry per number.
  struct Factors {
    alignas(64) double velocity_per_force[kNumbers];  ///< s/kg, gained in a step
    alignas(64) double spin_per_torque[kNumbers];     ///< s/(kg m^2), gained in a step
    alignas(64) double drag[kNumbers];                ///< kg/s
    alignas(64) double weight[kNumbers];              ///< N
  };

  void set(Factors& factors, std::size_t sphere, const Body& body) const;
  template <class Visit>
  void for_groups(const Grains& grains, std::size_t begin, std::size_t end, const Visit& visit) const;
  double kick(Grains& grains, std::size_t begin, std::size_t end, const double* contact_forces) const;
  void kick_spin(Grains& grains, std::size_t begin, std::size_t end, const double* contact_moments) const;
  double slow_rolling(Grains& grains, std::size_t begin, std::size_t end, const double* loads) const;

  std::vector<Body> bodies_;  ///< one a particle type
  Factors monodisperse_;      ///< where there is one particle type
  bool rotates_, rolls_;
  double time_step_;
  InstructionSet instructions_;
};

}  // namespace diefill::engine
