// Many touching pairs at a time: what happens between two spheres, in a loop that compilers turn into vector
// instructions. Grain and wall loops both pack their pairs into batches, let them react and hand out the
// forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/contact_parameters.h"
#include "engine/lanes.h"
#include "engine/laws/reaction.h"
#include "engine/reciprocal_root.h"

namespace diefill::engine {

/// Pairs of one batch, one lane each. In: the first group; out: the second. `place` only matters where
/// moments are taken about a reference point.
template <class Law>
struct ContactBatch {
  static constexpr std::size_t kLanes = 64;
  static constexpr std::size_t kMemory = static_cast<std::size_t>(Law::kMemory);
  using Scalars = Lanes<kLanes>;
  using Vectors = VectorLanes<kLanes>;

  std::size_t count = 0;
  Vectors separation;     ///< m, centre of i seen from that of j
  Vectors velocity;       ///< m/s, of i's centre against j's, or against the wall where they touch
  Vectors spin_sum;       ///< rad/s, sum of both angular velocities; for walls that of i
  Vectors relative_spin;  ///< rad/s, angular velocity of i less that of j; only set for laws that roll and
                          ///< for pairs of composed grains
  Vectors place;          ///< m, centre of i seen from the reference point
  Scalars memory[std::max<std::size_t>(1, kMemory)];

  Vectors normal;        ///< from j to i
  Scalars root_overlap;  ///< m^(1/2), for laws in stages
  Vectors force;         ///< N on i
  Vectors moment;        ///< N m on i
  Vectors other_moment;  ///< N m on j; only set where it is not the obvious one
  Scalars load, overlap;
  Scalars viscous_power, friction_power, rolling_power;  ///< W

  /// Which pair of kinds a lane is; only set where grains are not all alike.
  std::uint32_t kinds[kLanes + kLaneGroup];

  /// Calls change(memory) with what the pair of a lane remembers.
  template <class Change>
  void change_memory(std::size_t lane, const Change& change) {
    double numbers[kMemory + 1];
    for (std::size_t k = 0; k < kMemory; ++k) numbers[k] = memory[k][lane];
    change(numbers);
    for (std::size_t k = 0; k < kMemory; ++k) memory[k][lane] = numbers[k];
  }

  /// Fills the last group with copies of the last pair, so that whole groups hold numbers that make sense.
  void fill_last_group() {
    for (std::size_t lane = count; lane < whole_groups(count); ++lane) {
      separation.set(lane, separation[count - 1]);
      velocity.set(lane, velocity[count - 1]);
      spin_sum.set(lane, spin_sum[count - 1]);
      relative_spin.set(lane, relative_spin[count - 1]);
      place.set(lane, place[count - 1]);
      for (std::size_t k = 0; k < kMemory; ++k) memory[k][lane] = memory[k][count - 1];
      kinds[lane] = kinds[count - 1];
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
struct PairLaw {
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

/// Where the pairs meet: overlaps and normals.
template <class Law, class OfLane>
void meet(ContactBatch<Law>& batch, const OfLane& of_lane) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    const Vector3 separation = batch.separation[lane];
    const double squared = dot(separation, separation), inverse = reciprocal_root(squared);
    batch.overlap[lane] = reach.contact - squared * inverse;
    batch.normal.set(lane, inverse * separation);
  }
}

/// What laws in stages need before they react.
template <class Law, class OfLane>
void turn_memory(ContactBatch<Law>& batch, const OfLane& of_lane) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane)
    batch.root_overlap[lane] = batch.overlap[lane] * reciprocal_root(batch.overlap[lane]);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    batch.change_memory(lane, [&](double* memory) { law.turn(memory, batch.normal[lane]); });
  }
}

/// Forces of all pairs in the batch; `of_lane(lane)` is the PairLaw of each. `kComposed`: moments are about
/// the reference point, otherwise about the centres of i and j. `kUnequal`: radii of i and j may differ.
template <LeverArm kArm, bool kComposed, bool kUnequal = false, class Law, class OfLane>
void react(ContactBatch<Law>& batch, const OfLane& of_lane, double time_step) {
  using Arms = Lever<kArm>;
  meet(batch, of_lane);
  if constexpr (Law::kInStages) turn_memory(batch, of_lane);
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto& [law, reach] = of_lane(lane);
    laws::ContactState contact;
    contact.overlap = batch.overlap[lane];
    contact.normal = batch.normal[lane];
    contact.velocity = batch.velocity[lane];
    contact.time_step = contact.rolling_step = time_step;
    const double arm = Arms::arm(reach.radius, contact.overlap);
    const double other_arm = kUnequal ? Arms::arm(reach.contact - reach.radius, contact.overlap) : arm;
    if constexpr (Arms::kTurns && kUnequal)
      contact.velocity -= 0.5 * cross((arm + other_arm) * batch.spin_sum[lane] +
                                          (arm - other_arm) * batch.relative_spin[lane],
                                      contact.normal);
    else if constexpr (Arms::kTurns)
      contact.velocity -= arm * cross(batch.spin_sum[lane], contact.normal);
    if constexpr (Law::kRolls) contact.spin = batch.relative_spin[lane];

    laws::Reaction reaction;
    batch.change_memory(lane, [&](double* memory) {
      if constexpr (Law::kInStages)
        reaction = law.react_turned(contact, batch.root_overlap[lane], memory);
      else
        reaction = law.react(contact, memory);
    });

    batch.force.set(lane, reaction.force);
    batch.load[lane] = reaction.load;
    batch.viscous_power[lane] = reaction.viscous_power;
    batch.friction_power[lane] = reaction.friction_power;
    if constexpr (Law::kRolls) batch.rolling_power[lane] = reaction.rolling_power;
    if constexpr (Arms::kTurns) {
      Vector3 point = (-arm) * contact.normal;
      if constexpr (kComposed) point += batch.place[lane];
      Vector3 moment = cross(point, reaction.force);
      if constexpr (Law::kRolls) moment += reaction.couple;
      batch.moment.set(lane, moment);
      if constexpr (kComposed && Arms::kOtherDiffers)
        batch.other_moment.set(
            lane,
            -moment - cross(Arms::offset_of_other(reach, contact.overlap) * contact.normal, reaction.force));
      if constexpr (!kComposed && kUnequal)
        batch.other_moment.set(lane, -cross(other_arm * contact.normal, reaction.force) - reaction.couple);
      else if constexpr (!kComposed && Law::kRolls)
        batch.other_moment.set(lane, moment - 2 * reaction.couple);
    }
  }
}

}  // namespace diefill::engine
