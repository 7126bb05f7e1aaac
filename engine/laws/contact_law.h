// Bierwisch's contact law composed of fixed parts. Plain numbers in, forces out: the pair loops for grains
// and walls and the tests all call these few lines.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/laws/cohesion.h"
#include "engine/laws/contact_parameters.h"
#include "engine/laws/damping.h"
#include "engine/laws/hertz.h"
#include "engine/laws/reaction.h"
#include "engine/laws/tangential_spring.h"

namespace diefill::engine::laws {

/// Normal parts of a contact force in N, positive when repulsive.
struct NormalForce {
  double elastic, cohesive, viscous;
  double total() const { return elastic + cohesive + viscous; }
  /// |f_e + f_v|: the load in Coulomb's limit and rolling friction (Bierwisch 2009, Eqs. 2.7, 2.11).
  double load() const { return std::abs(elastic + viscous); }
};

/// Hertz, cohesion, damping and friction between spheres of one effective radius.
template <class Cohesion, class Friction>
struct ContactLaw {
  static constexpr int kHistory = Friction::kHistory;  ///< numbers stored per touching pair
  static constexpr bool kRolls = false;                ///< whether relative spins matter
  /// Whether the parts are selected at run time. Not here: loops over many pairs call turn(), stretch() and
  /// react_stretched() one after the other, so that while one pair waits for a root the processor works on
  /// others.
  static constexpr bool kByParts = false;
  Hertz elastic;
  Cohesion cohesion;
  HertzianDamping damping;
  Friction friction;
  double rolling_friction = 0;  ///< m, mu_r

  ContactLaw(const ContactParameters& parameters, double effective_radius)
      : elastic(parameters.reduced_modulus, effective_radius),
        cohesion(parameters.work_of_adhesion, parameters.reduced_modulus, effective_radius),
        damping(parameters.damping, effective_radius),
        friction(parameters.tangential, parameters.friction, effective_radius),
        rolling_friction(parameters.rolling_friction) {}

  /// Force between touching spheres; advances the pair's `history`.
  Reaction react(const ContactState& contact, double* history) const {
    turn(history, contact.normal);
    return react_stretched(stretch(contact, history), contact.normal, history);
  }
  /// Turns the pair's history with its `normal`.
  void turn(double* history, Vector3 normal) const { friction.turn(history, normal); }
  /// Stretches the pair's history after turn() and returns what react_stretched() needs.
  StretchedContact stretch(const ContactState& contact, double* history) const {
    StretchedContact stretched;
    stretched.overlap = contact.overlap;
    // Rounding can make the overlap of a pair that just touches negative.
    stretched.root_overlap = std::sqrt(contact.overlap > 0 ? contact.overlap : 0.0);
    stretched.separation_speed = dot(contact.velocity, contact.normal);
    stretched.sliding = contact.velocity - stretched.separation_speed * contact.normal;
    friction.stretch(history, stretched.sliding, contact.time_step);
    return stretched;
  }
  /// The same as react(), after turn() and stretch().
  Reaction react_stretched(const StretchedContact& contact, Vector3 unit_normal, double* history) const {
    const NormalForce parts = normal(contact.overlap, contact.root_overlap, contact.separation_speed);
    Reaction reaction;
    reaction.load = parts.load();
    const Vector3 tangential = friction.limited(history, contact.root_overlap, reaction.load);
    reaction.force = parts.total() * unit_normal + tangential;
    reaction.viscous_power = parts.viscous * contact.separation_speed;
    reaction.friction_power = dot(tangential, contact.sliding);
    return reaction;
  }

  /// Normal forces at overlap h (m) and speed of separation (m/s), given sqrt(h).
  NormalForce normal(double overlap, double root_overlap, double separation_speed) const {
    return {elastic.force(overlap, root_overlap), cohesion.force(overlap, root_overlap),
            damping.force(root_overlap, separation_speed)};
  }
  /// Energy in J that the normal springs hold at overlap h (m).
  double energy(double overlap, const double* = nullptr) const {
    return elastic.energy(overlap) + cohesion.energy(overlap);
  }
  /// m, gap at which the pair still interacts: 0, it must touch.
  double range() const { return 0; }
  /// Factors of the history's numbers when the pair is stored the other way round.
  static std::vector<double> history_signs() { return std::vector<double>(kHistory, -1.0); }
  /// What each number of the history means: the spring of friction.
  static std::vector<std::uint32_t> history_layout() { return std::vector<std::uint32_t>(kHistory, 1); }
};

}  // namespace diefill::engine::laws
