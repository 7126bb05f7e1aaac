// A contact law put together from one part of each kind: motion of the pair in, force and couple out. Grains,
// walls, the engine and the slow reference all call `react`.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/laws/parts.h"
#include "engine/laws/reaction.h"

namespace diefill::engine::laws {

/// How the load of friction and rolling limits is made of the normal part's limit and damping.
enum class LoadRule {
  with_damping,   ///< |limit + viscous| (Bierwisch 2009, Eqs. 2.7, 2.11; Hu 2024 for Hertz; Kottlan 2018)
  without,        ///< |limit| (Hu 2024 for JKR)
  repulsive_only  ///< max(0, limit + viscous)
};

template <NormalPart Normal, DampingPart Damping, FrictionPart Friction, RollingPart Rolling,
          AttractionPart Attraction>
struct ComposedLaw {
  // Memory of a pair: one part after the other, the attraction's last because it outlives the contact.
  static constexpr int kFrictionMemory = Normal::kMemory;
  static constexpr int kRollingMemory = kFrictionMemory + Friction::kMemory;
  static constexpr int kAttractionMemory = kRollingMemory + Rolling::kMemory;
  static constexpr int kMemory = kAttractionMemory + Attraction::kMemory;

  Normal normal;
  Damping damping;
  Friction friction;
  Rolling rolling;
  Attraction attraction;
  LoadRule load_rule = LoadRule::with_damping;

  /// m, the largest gap at which the pair must still be looked at.
  double range() const { return attraction.range(); }

  /// Force and couple at `state`; advances the pair's `memory` (kMemory doubles) by one time step, so it must
  /// be called once per pair and step. Apart, only the attraction acts and the contact's memory is wiped.
  Reaction react(const ContactState& state, double* memory) const {
    Reaction reaction;
    const double speed = dot(state.velocity, state.normal);
    reaction.attraction = attraction.force(-state.overlap, memory + kAttractionMemory);
    reaction.attraction_power = reaction.attraction * speed;
    reaction.force = reaction.attraction * state.normal;
    if (state.overlap > 0)
      touch(state, speed, memory, reaction);
    else
      std::fill_n(memory, kAttractionMemory, 0.0);
    return reaction;
  }

  /// J that the normal part holds and can give back.
  double contact_energy(double overlap, const double* memory) const {
    return overlap > 0 ? normal.energy(overlap, memory) : 0;
  }
  /// J of the distant attraction (negative), zero beyond its range.
  double attraction_energy(double overlap, const double* memory) const {
    return attraction.energy(-overlap, memory + kAttractionMemory);
  }

 private:
  void touch(const ContactState& state, double speed, double* memory, Reaction& reaction) const {
    const double root_overlap = std::sqrt(state.overlap);
    const StaticForce still = normal.force(state.overlap, root_overlap, memory);
    reaction.viscous = damping.force(state.overlap, root_overlap, speed);
    reaction.load = load(still.limit, reaction.viscous);
    const Vector3 sliding = state.velocity - speed * state.normal;
    const Vector3 tangential = friction.force(memory + kFrictionMemory, state.normal, sliding, root_overlap,
                                              reaction.load, state.time_step);
    reaction.couple = rolling.torque(memory + kRollingMemory, state.normal, state.spin, root_overlap, still,
                                     reaction.load, state.rolling_step);
    reaction.force += (still.force + reaction.viscous) * state.normal + tangential;
    reaction.normal_power = still.force * speed;
    reaction.viscous_power = reaction.viscous * speed;
    reaction.friction_power = dot(tangential, sliding);
    reaction.rolling_power = dot(reaction.couple, state.spin);
  }

  double load(double limit, double viscous) const {
    const double sum = load_rule == LoadRule::without ? limit : limit + viscous;
    return load_rule == LoadRule::repulsive_only ? std::max(0.0, sum) : std::abs(sum);
  }
};

}  // namespace diefill::engine::laws
