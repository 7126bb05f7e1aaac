// Stiffness, damping and forces of a contact law without integrating it in time, and the time steps that they
// allow.
#pragma once

#include <array>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/powder/grain_shape.h"

namespace diefill::engine {

/// Springs and dampers of a pair at one overlap.
struct ContactSprings {
  double normal = 0, tangential = 0;        ///< N/m
  double rolling = 0;                       ///< N m per radian
  double damping = 0, sliding_damping = 0;  ///< kg/s
};

/// The law of one pair as it is simulated.
class LawProbe {
 public:
  explicit LawProbe(const laws::GeneralContactLaw& law) : law_(law) {}

  /// N, of a first approach to `overlap` (m), damping left out.
  double loading_force(double overlap) const;
  /// J that the attraction has given to a pair when it comes to touch.
  double energy_of_approach() const;
  /// N, of the attraction where the pair comes to touch.
  double pull_at_touch() const;
  /// m: where the work of a first approach has used up `energy` (J), at most `deepest` (m).
  double overlap_of_energy(double energy, double deepest) const;
  /// Of a fresh contact at `overlap` (m). A rolling spring that is made for the time step has no part in it.
  ContactSprings springs(double overlap) const;

 private:
  using History = std::array<double, static_cast<std::size_t>(laws::GeneralContactLaw::kHistory)>;

  laws::Reaction react(double overlap, Vector3 velocity, Vector3 spin, double time_step) const;
  double work_of_approach(double overlap) const;

  laws::GeneralContactLaw law_;
};

/// What moves where a contact pushes, drags and rolls; reduced where both grains do.
struct ContactMasses {
  double normal = 0;   ///< kg, on the outermost sphere's arm: mobility()
  double sliding = 0;  ///< kg, on the outermost point's arm
  double inertia = 0;  ///< kg m^2; infinite where grains do not turn
};

/// Of a grain that meets something fixed; `shape` with moments of inertia as torques balance with.
ContactMasses masses_of(const GrainShape& shape);
/// Of two grains that meet.
ContactMasses reduced(const ContactMasses& one, const ContactMasses& other);
/// Of a grain among others no lighter than it: half of the smaller of each.
ContactMasses half_of_smaller(const ContactMasses& one, const ContactMasses& other);

/// s, the smallest limit of `contacts` such contacts on these masses at once: 2 sqrt(m / k) of a spring, 2 m
/// / c of a damper. The damper's is that of a rebound of a few steps; in a contact that lasts it is stable up
/// to half of that, and less beside a spring: stable_step().
double step_limit(const ContactSprings& springs, const ContactMasses& masses, double contacts);

/// s that a pair of reduced mass `mass` (kg) at 1.5 times the speed of escape takes to cross the steep part
/// of its attraction, energy over force: longer steps jump over it (STABILITY.md, van der Waals cut-offs).
double crossing_time(const LawProbe& probe, double mass);

}  // namespace diefill::engine
