// Many touching pairs at a time: what happens between two spheres, in a loop that compilers turn into vector
// instructions. Grain and wall loops both pack their pairs into batches, let them react and hand out the
// forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/contact/contacts_in_parts.h"
#include "engine/laws/contact_parameters.h"
#include "engine/laws/reaction.h"
#include "engine/numerics/lanes.h"
#include "engine/numerics/reciprocal_root.h"

namespace diefill::engine {

/// Pairs of one batch, one lane each. In: the first group; out: the second. `place` only matters where
/// moments are taken about a reference point.
template <class Law>
struct ContactBatch {
  static constexpr std::size_t kLanes = 64;
  static constexpr std::size_t kHistory = static_cast<std::size_t>(Law::kHistory);
  using Scalars = Lanes<kLanes>;
  using Vectors = VectorLanes<kLanes>;

  std::size_t count = 0;
  Vectors separation;     ///< m, centre of i seen from that of j
  Vectors velocity;       ///< m/s, of i's centre against j's, or against the wall where they touch; laws in
                          ///< stages leave the sliding velocity here
  Vectors spin_sum;       ///< rad/s, sum of both angular velocities; for walls that of i
  Vectors relative_spin;  ///< rad/s, angular velocity of i less that of j; only set for laws that roll and
                          ///< for pairs of clumped grains
  Vectors place;          ///< m, centre of i seen from the reference point
  Scalars history[std::max<std::size_t>(1, kHistory)];

  Vectors normal;                          ///< from j to i
  Scalars root_overlap, separation_speed;  ///< m^(1/2), m/s along the normal; for laws in stages
  Vectors force;                           ///< N on i
  Vectors moment;                          ///< N m on i
  Vectors other_moment;                    ///< N m on j; only set where it is not the obvious one
  Scalars load, overlap;
  Scalars viscous_power, friction_power, rolling_power;  ///< W

  /// For laws by parts: the law of a lane, and how far it has come.
  const Law* law[Law::kByParts ? kLanes + kLaneGroup : 1];
  /// For laws that differ from lane to lane: loops that look reaches up do not become vector instructions.
  Lanes<Law::kByParts ? kLanes : 1> reach_contact, reach_radius;  ///< m, as PairReach
  ContactsInParts<Law::kByParts ? kLanes : 1> parts;
  Vectors torque;  ///< N m on i besides that of the force; for laws by parts

  /// Number of the lane's pair of sphere classes; only set where there are several.
  std::uint32_t classes[kLanes + kLaneGroup];

  /// Calls change(history) with the contact history of a lane.
  template <class Change>
  void change_history(std::size_t lane, const Change& change) {
    double numbers[kHistory + 1];
    for (std::size_t k = 0; k < kHistory; ++k) numbers[k] = history[k][lane];
    change(numbers);
    for (std::size_t k = 0; k < kHistory; ++k) history[k][lane] = numbers[k];
  }

  /// What the law says about a lane.
  void put(std::size_t lane, const laws::Reaction& reaction) {
    force.set(lane, reaction.force);
    if constexpr (Law::kByParts) torque.set(lane, reaction.torque);
    load[lane] = reaction.load;
    viscous_power[lane] = reaction.viscous_power;
    friction_power[lane] = reaction.friction_power;
    if constexpr (Law::kRolls) rolling_power[lane] = reaction.rolling_power;
  }

  /// For laws that roll between grains that do not turn, whose spins nobody brings in.
  void set_no_spins() {
    for (std::size_t lane = 0; lane < kLanes; ++lane) relative_spin.set(lane, Vector3{});
  }

  /// Fills the last group with copies of the last pair, so that whole groups hold numbers that make sense.
  void fill_last_group() {
    for (std::size_t lane = count; lane < whole_groups(count); ++lane) {
      separation.set(lane, separation[count - 1]);
      velocity.set(lane, velocity[count - 1]);
      spin_sum.set(lane, spin_sum[count - 1]);
      relative_spin.set(lane, relative_spin[count - 1]);
      place.set(lane, place[count - 1]);
      for (std::size_t k = 0; k < kHistory; ++k) history[k][lane] = history[k][count - 1];
      classes[lane] = classes[count - 1];
    }
  }
};

/// Turns the difference of velocities that two rigid grains have at the reference point into that of the
/// centres of i and j: v_i - v_j = u_i - u_j + w_i x p_i - w_j x p_j with places p_i and p_j = p_i - s, s the
/// separation, written with sum and difference of the spins.
template <class Law>
void bring_velocities_to_centres(ContactBatch<Law>& batch) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const Vector3 half = 0.5 * batch.separation[lane];
    batch.velocity.set(lane, batch.velocity[lane] +
                                 cross(batch.relative_spin[lane], batch.place[lane] - half) +
                                 cross(batch.spin_sum[lane], half));
  }
}

/// The radii of a pair.
struct PairReach {
  double contact;  ///< m, sum of both radii
  double radius;   ///< m, of i
};

/// What acts between the pair of a lane.
template <class Law>
struct LawOfPair {
  const Law& law;
  PairReach reach;
};

/// How a contact force turns the grain of sphere i (and j): where it acts.
template <LeverArm kArm>
struct Lever {
  /// m, from i's centre along -normal to the point where velocities are compared and the force acts.
  static double arm(double radius, double overlap) {
    if constexpr (kArm == LeverArm::surface) return radius;
    if constexpr (kArm == LeverArm::contact) return radius - 0.5 * overlap;
    return 0;
  }
  /// m, from that point along the normal to the one where the force on j acts.
  static double offset_of_other(const PairReach& reach, double overlap) {
    if constexpr (kArm == LeverArm::surface) return overlap;
    if constexpr (kArm == LeverArm::center) return overlap - reach.contact;
    return 0;
  }
  static constexpr bool kTurns = kArm != LeverArm::none;
  /// Whether j's moment about a common point is not just the opposite of i's.
  static constexpr bool kOtherDiffers = kArm == LeverArm::surface || kArm == LeverArm::center;
};

/// Computes overlaps and normals of all pairs.
template <class Law, class ReachOf>
void compute_overlaps(ContactBatch<Law>& batch, const ReachOf& reach_of) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const PairReach reach = reach_of(lane);
    const Vector3 separation = batch.separation[lane];
    const double squared = dot(separation, separation), inverse = reciprocal_root(squared);
    batch.overlap[lane] = reach.contact - squared * inverse;
    batch.normal.set(lane, inverse * separation);
  }
}

/// The state of a lane's contact.
template <LeverArm kArm, bool kUnequal, class Law>
laws::ContactState contact_of(const ContactBatch<Law>& batch, std::size_t lane, const PairReach& reach,
                              double time_step) {
  using Arms = Lever<kArm>;
  laws::ContactState contact;
  contact.overlap = batch.overlap[lane];
  contact.normal = batch.normal[lane];
  contact.velocity = batch.velocity[lane];
  contact.time_step = contact.rolling_step = time_step;
  const double arm = Arms::arm(reach.radius, contact.overlap);
  if constexpr (Arms::kTurns && kUnequal) {
    const double other_arm = Arms::arm(reach.contact - reach.radius, contact.overlap);
    contact.velocity -=
        0.5 * cross((arm + other_arm) * batch.spin_sum[lane] + (arm - other_arm) * batch.relative_spin[lane],
                    contact.normal);
  } else if constexpr (Arms::kTurns) {
    contact.velocity -= arm * cross(batch.spin_sum[lane], contact.normal);
  }
  if constexpr (Law::kRolls) contact.spin = batch.relative_spin[lane];
  return contact;
}

/// Puts the moments into the batch that a lane's `force` and `torque` on i cause.
template <LeverArm kArm, bool kClumps, bool kUnequal, class Law>
void put_moments(Vector3 force, Vector3 torque, const PairReach& reach, std::size_t lane,
                 ContactBatch<Law>& batch) {
  using Arms = Lever<kArm>;
  if constexpr (!Arms::kTurns) return;
  const double overlap = batch.overlap[lane], arm = Arms::arm(reach.radius, overlap);
  const Vector3 normal = batch.normal[lane];
  Vector3 point = (-arm) * normal;
  if constexpr (kClumps) point += batch.place[lane];
  Vector3 moment = cross(point, force);
  if constexpr (Law::kRolls) moment += torque;
  batch.moment.set(lane, moment);
  if constexpr (kClumps && Arms::kOtherDiffers)
    batch.other_moment.set(lane, -moment - cross(Arms::offset_of_other(reach, overlap) * normal, force));
  if constexpr (!kClumps && kUnequal) {
    const double other_arm = Arms::arm(reach.contact - reach.radius, overlap);
    batch.other_moment.set(lane, -cross(other_arm * normal, force) - torque);
  } else if constexpr (!kClumps && Law::kRolls) {
    batch.other_moment.set(lane, moment - 2 * torque);
  }
}

/// The reaction of all pairs by a law in stages, one root or quotient each: a stage is short enough for the
/// processor to have several groups of lanes under way. What a stage leaves to the next takes the place of
/// what it has used up.
template <LeverArm kArm, bool kClumps, class Law, class OfLane>
void react_in_stages(ContactBatch<Law>& batch, const OfLane& of_lane, double time_step) {
  static_assert(!Law::kRolls);
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    batch.change_history(lane, [&](double* history) { law.turn(history, batch.normal[lane]); });
  }
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    const laws::ContactState contact = contact_of<kArm, false>(batch, lane, reach, time_step);
    laws::StretchedContact stretched;
    batch.change_history(lane, [&](double* history) { stretched = law.stretch(contact, history); });
    batch.root_overlap[lane] = stretched.root_overlap;
    batch.separation_speed[lane] = stretched.separation_speed;
    batch.velocity.set(lane, stretched.sliding);
  }
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    const laws::StretchedContact stretched{batch.overlap[lane], batch.root_overlap[lane],
                                           batch.separation_speed[lane], batch.velocity[lane]};
    laws::Reaction reaction;
    batch.change_history(lane, [&](double* history) {
      reaction = law.react_stretched(stretched, batch.normal[lane], history);
    });
    batch.put(lane, reaction);
    put_moments<kArm, kClumps, false>(reaction.force, {}, reach, lane, batch);
  }
}

/// The reaction of all pairs by a law of parts; `reach_of(lane)` is the PairReach of each.
template <LeverArm kArm, bool kClumps, bool kUnequal, class Law, class ReachOf>
void react_in_parts(ContactBatch<Law>& batch, const ReachOf& reach_of, InstructionSet instructions,
                    double time_step) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane)
    batch.velocity.set(lane, contact_of<kArm, kUnequal>(batch, lane, reach_of(lane), time_step).velocity);
  react_by_parts(batch, instructions, time_step);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane)
    put_moments<kArm, kClumps, kUnequal>(batch.force[lane], batch.torque[lane], reach_of(lane), lane, batch);
}

/// Forces of all pairs in the batch; `of_lane(lane)` is the LawOfPair of each. `kClumps`: moments are about
/// the reference point, otherwise about the centres of i and j. `kUnequal`: radii of i and j may differ.
/// `kLookedUp`: of_lane() looks laws up, instead of giving all lanes the same one.
template <LeverArm kArm, bool kClumps, bool kUnequal = false, bool kLookedUp = kUnequal, class Law,
          class OfLane>
void react(ContactBatch<Law>& batch, const OfLane& of_lane, InstructionSet instructions, double time_step) {
  static_assert(Law::kByParts || !(kUnequal || kLookedUp));
  if constexpr (!Law::kByParts) {
    compute_overlaps(batch, [&](std::size_t lane) { return of_lane(lane).reach; });
    react_in_stages<kArm, kClumps>(batch, of_lane, time_step);
  } else {
    for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane) {
      const auto& [law, reach] = of_lane(lane);
      batch.law[lane] = &law;
      if constexpr (!kLookedUp) continue;
      batch.reach_contact[lane] = reach.contact;
      batch.reach_radius[lane] = reach.radius;
    }
    const auto reach_of = [&](std::size_t lane) {
      if constexpr (kLookedUp) return PairReach{batch.reach_contact[lane], batch.reach_radius[lane]};
      return of_lane(lane).reach;
    };
    compute_overlaps(batch, reach_of);
    react_in_parts<kArm, kClumps, kUnequal>(batch, reach_of, instructions, time_step);
  }
}

}  // namespace diefill::engine
