#include <bit>

#include "engine/contact_kernel.h"
#include "engine/eight_distances.h"
#include "engine/grain_batch.h"
#include "engine/pair_laws.h"
#include "engine/vector_width.h"

namespace diefill::engine {

void BlockTally::start(std::size_t bodies) {
  viscous_work = tangential_work = drag_work = rolling_work = 0;
  overlap = {};
  touching = 0;
  body_force.assign(bodies, Eigen::Vector3d::Zero());
  body_torque.assign(bodies, Eigen::Vector3d::Zero());
}

namespace {

/// Which of up to 64 near pairs touched in the last step and which do now, one bit each.
struct Touches {
  std::uint64_t last, now;
};

/// Lists those that touch now. `before`: pairs of the table before these that touched in the last step.
inline void list_touching(const GrainPair* near, Touches touches, std::uint32_t before,
                          TouchingPair* touching) {
  const auto up_to_lowest = [](std::uint64_t bits) { return bits ^ (bits - 1); };
  // Whether a near pair touches cannot be guessed: no branch depends on a single one.
  TouchingPair* next = touching;
  for (std::uint64_t left = touches.now; left != 0; left &= left - 1)
    *next++ = {near[std::countr_zero(left)],
               before + static_cast<std::uint32_t>(std::popcount(touches.last & up_to_lowest(left)))};
  // Whether one has just begun can: it is rare.
  for (std::uint64_t begun = touches.now & ~touches.last; begun != 0; begun &= begun - 1)
    touching[std::popcount(touches.now & up_to_lowest(begun)) - 1].memory = GrainPairTable::kNothing;
}

/// Pairs between grains. `Pairs`: which law acts between which. `kComposed`: several spheres a grain, moments
/// about the block's reference point.
template <class Pairs, LeverArm kArm, bool kComposed>
class GrainLoop final : public PairLoop {
 public:
  explicit GrainLoop(Pairs pairs) : pairs_(std::move(pairs)) {}

  void add_forces(Block& block, const ContactScene& scene, std::vector<ContactSum>& sums,
                  BlockTally& tally) const override {
    // Contacts begin and end: what pairs remember is written anew in every step, closely packed.
    thread_local std::vector<double> remembered;
    thread_local std::vector<TouchingPair> touching;
    GrainPairTable& table = block.grain_pairs;
    table.make_room_to_remember(remembered);
    touching.resize(table.size());
    std::size_t count = 0;
    with_width(scene.instructions, [&](auto wide) {
      count = find_touching<decltype(wide)::value>(block, scene.spheres, touching.data());
    });
    Batch& batch = batch_of_thread<Batch>();
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < count; done += batch.count) {
      batch.count = std::min(count - done, Batch::kLanes);
      std::copy_n(touching.data() + done, batch.count, batch.pair);
      double* memory = remembered.data() + (done + 1) * table.width;
      with_width(scene.instructions, [&](auto wide) {
        constexpr bool kWide = decltype(wide)::value;
        pack<kWide>(block, scene.spheres, batch);
        react_all(batch, scene.time_step);
        hand_out<kWide>(batch, block, sums);
        batch.template write_memory<kWide>(memory);
        batches.add(batch);
      });
      if constexpr (!Pairs::kAlike)
        batches.add_over_radius(batch, [&](std::size_t lane) { return smaller_radius(batch.kinds[lane]); });
    }
    table.keep(remembered, count);
    batches.book(scene.time_step, tally);
    tally.overlap.grains = std::max(tally.overlap.grains, batches.deepest());
    const double over_radius =
        Pairs::kAlike ? batches.deepest() / smaller_radius(0) : batches.deepest_over_radius();
    tally.overlap.grains_over_radius = std::max(tally.overlap.grains_over_radius, over_radius);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    Batch& batch = batch_of_thread<Batch>();
    const GrainPairTable& table = block.grain_pairs;
    std::uint32_t place = GrainPairTable::kNothing;
    batch.count = 0;
    const auto visit_batch = [&] {
      if (batch.count == 0) return;
      pack<false>(block, scene.spheres, batch);
      react_all(batch, 0);
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = batch.pair[lane].pair;
        const Vector3 separation = batch.separation[lane];
        const double radius = pairs_.of(kinds_of(batch, lane)).reach.radius;
        const double share = (radius - 0.5 * batch.overlap[lane]) / length(separation);
        visit(
            {pair.own, pair.other, batch.force[lane], scene.spheres.position(pair.own) - share * separation});
      }
      batch.count = 0;
    };
    table.visit_touching([&](std::size_t p, const double*) {
      batch.pair[batch.count] = {table.pair[p], ++place};
      if (++batch.count == Batch::kLanes) visit_batch();
    });
    visit_batch();
  }

  double stored_energy(const Block& block, const ContactScene& scene) const override {
    double energy = 0;
    const auto& table = block.grain_pairs;
    std::uint32_t place = GrainPairTable::kNothing;
    for (std::size_t p = 0; p < table.size(); ++p) {
      const GrainPair pair = table.pair[p];
      place += table.touching[p];
      const double* memory = table.memory_at(table.touching[p] ? place : GrainPairTable::kNothing);
      const auto [law, reach] = pairs_.of(pairs_.kinds(block, pair));
      const double overlap =
          reach.contact - length(scene.spheres.position(pair.own) - scene.spheres.position(pair.other));
      if (overlap > 0) energy += law.energy(overlap, memory);
    }
    return energy;
  }

  std::vector<double> memory_signs() const override { return Law::memory_signs(); }
  bool rolls() const override { return kRolls && pairs_.rolling_friction() != 0; }
  double range() const override { return pairs_.range(); }

 private:
  using Law = typename Pairs::Law;
  using Batch = GrainBatch<Law>;

  static constexpr std::size_t kTested = 64;  ///< pairs at a time
  static constexpr bool kTurns = Lever<kArm>::kTurns;
  /// Loads count where single spheres roll.
  static constexpr bool kRolls = !kComposed && kTurns;
  /// Whether the reaction on j is not the one on i with other signs.
  static constexpr bool kOtherDiffers =
      kTurns && (kComposed ? Lever<kArm>::kOtherDiffers : static_cast<bool>(Law::kRolls));
  static_assert(Pairs::kAlike || Law::kRolls, "unequal radii need the relative spin of a pair");

  static std::uint32_t kinds_of(const Batch& batch, std::size_t lane) {
    return Pairs::kAlike ? 0 : batch.kinds[lane];
  }
  /// m, of the pair's two spheres.
  double smaller_radius(std::uint32_t kinds) const {
    const PairReach reach = pairs_.of(kinds).reach;
    return Pairs::kAlike ? reach.radius : std::min(reach.radius, reach.contact - reach.radius);
  }

  void react_all(Batch& batch, double time_step) const {
    if constexpr (kComposed) bring_velocities_to_centres(batch);
    react<kArm, kComposed, !Pairs::kAlike>(
        batch, [&](std::size_t lane) { return pairs_.of(kinds_of(batch, lane)); }, time_step);
  }

  /// Distances are tested first and touching pairs collected, so that the costly part runs without guessing.
  /// Returns how many were written to `touching`.
  template <bool kWide>
  std::size_t find_touching(Block& block, const LocalSpheres& spheres, TouchingPair* touching) const {
    GrainPairTable& table = block.grain_pairs;
    const GrainPair* pair = table.pair.data();
    std::uint8_t* touches = table.touching.data();
    std::size_t count = 0;
    std::uint32_t before = 0;  // pairs so far that touched in the last step
    for (std::size_t first = 0; first < table.size(); first += kTested) {
      std::uint64_t last = 0, now = 0;
      for (std::size_t k = 0; k < kTested && first + k < table.size(); k += kLaneGroup) {
        const std::size_t some = std::min(kLaneGroup, table.size() - first - k);
        const Touches eight =
            !kWide ? test_one_by_one(block, spheres, pair + first + k, touches + first + k, some)
            : some == kLaneGroup ? test_eight(block, spheres, pair + first + k, touches + first + k)
                                 : test_few(block, spheres, pair + first + k, touches + first + k, some);
        last |= eight.last << k;
        now |= eight.now << k;
      }
      list_touching(pair + first, {last, now}, before, touching + count);
      count += static_cast<std::size_t>(std::popcount(now));
      before += static_cast<std::uint32_t>(std::popcount(last));
    }
    return count;
  }

  /// Notes in `touches` which of eight near pairs touch.
  Touches test_eight(const Block& block, const LocalSpheres& spheres, const GrainPair* near,
                     std::uint8_t* touches) const {
    Eight squares, reach_squared;
    squares_of_eight(
        [&](int k, Four& between) {
          Four other;
          __builtin_memcpy(&between, spheres.centre(near[k].own).value, sizeof between);
          __builtin_memcpy(&other, spheres.centre(near[k].other).value, sizeof other);
          between -= other;
        },
        squares);
    if constexpr (Pairs::kAlike)
      reach_squared = Eight{} + pairs_.reach_squared(0);
    else
      for (int k = 0; k < 8; ++k) reach_squared[k] = pairs_.reach_squared(pairs_.kinds(block, near[k]));
    std::uint64_t last;
    const std::uint64_t now = bytes_where_less(squares, reach_squared);
    __builtin_memcpy(&last, touches, sizeof last);
    __builtin_memcpy(touches, &now, sizeof now);
    return {bits_from_bytes(last), bits_from_bytes(now)};
  }
  /// The same of fewer, at the end of a table.
  Touches test_few(const Block& block, const LocalSpheres& spheres, const GrainPair* near,
                   std::uint8_t* touches, std::size_t some) const {
    GrainPair eight[kLaneGroup];
    std::uint8_t touch[kLaneGroup] = {};
    for (std::size_t k = 0; k < kLaneGroup; ++k) eight[k] = near[std::min(k, some - 1)];
    std::copy_n(touches, some, touch);
    Touches tested = test_eight(block, spheres, eight, touch);
    std::copy_n(touch, some, touches);
    tested.now &= (std::uint64_t{1} << some) - 1;
    return tested;
  }

  /// The same as both, without vectors of eight.
  Touches test_one_by_one(const Block& block, const LocalSpheres& spheres, const GrainPair* near,
                          std::uint8_t* touches, std::size_t some) const {
    const double alike_reach = Pairs::kAlike ? pairs_.reach_squared(0) : 0;
    Touches tested{0, 0};
    for (std::size_t k = 0; k < some; ++k) {
      const Vector3 between = spheres.position(near[k].own) - spheres.position(near[k].other);
      const double reach_squared =
          Pairs::kAlike ? alike_reach : pairs_.reach_squared(pairs_.kinds(block, near[k]));
      const bool now = dot(between, between) < reach_squared;
      tested.last |= std::uint64_t{touches[k]} << k;
      tested.now |= std::uint64_t{now} << k;
      touches[k] = now;
    }
    return tested;
  }

  /// Brings the batch's pairs into its lanes, whole groups of them: the last pair fills up.
  template <bool kWide>
  void pack(const Block& block, const LocalSpheres& spheres, Batch& batch) const {
    batch.fill_last_group();
    if constexpr (!Pairs::kAlike)
      for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane)
        batch.kinds[lane] = pairs_.kinds(block, batch.pair[lane].pair);
    batch.template spread_between<kWide>(spheres, block.grain_pairs);
    batch.template spread_motion<kWide, kComposed>(block, spheres);
    if constexpr (kComposed || (kTurns && Law::kRolls))
      for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane) {
        const GrainPair pair = batch.pair[lane].pair;
        if constexpr (kComposed) batch.place.set(lane, spheres.position(pair.own) - plain(block.reference));
        batch.relative_spin.set(lane, spheres.spin(block.slot_of<kComposed>(pair.own)) -
                                          spheres.spin(block.slot_of<kComposed>(pair.other)));
      }
  }

  /// Adds the batch's forces to `sums`.
  template <bool kWide>
  void hand_out(const Batch& batch, const Block& block, std::vector<ContactSum>& sums) const {
    const double rolling = kRolls ? pairs_.rolling_friction() : 0;
    const double turn = kComposed && !kOtherDiffers ? -1 : 1;
    if constexpr (kWide)
      hand_out_records(batch, block, Eight{1, 1, 1, 1, 1, 1, rolling, 0},
                       Eight{-1, -1, -1, turn, turn, turn, rolling, 0}, sums);
    else
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = batch.pair[lane].pair;
        const Vector3 force = batch.force[lane];
        const auto add = [&](LocalSphere sphere, Vector3 push, Vector3 moment) {
          ContactSum& sum = sums[block.slot_of<kComposed>(sphere)];
          sum.add_force(push);
          if constexpr (kTurns) sum.add_moment(moment);
          if constexpr (kRolls) sum.add_rolling_load(rolling * batch.load[lane]);
        };
        add(pair.own, force, batch.moment[lane]);
        add(pair.other, -force, kOtherDiffers ? batch.other_moment[lane] : turn * batch.moment[lane]);
      }
  }

  /// The same by way of records; signs: what the numbers of a reaction are multiplied by.
  void hand_out_records(const Batch& batch, const Block& block, const Eight& own_sign,
                        const Eight& other_sign, std::vector<ContactSum>& sums) const {
    batch.template for_reactions<kTurns, kOtherDiffers>(
        [&](GrainPair pair, const Eight& own, const Eight& other) {
          add_times(sums[block.slot_of<kComposed>(pair.own)].data(), own, own_sign);
          add_times(sums[block.slot_of<kComposed>(pair.other)].data(), other, other_sign);
        });
  }

  Pairs pairs_;
};

/// The loop over `pairs`.
template <LeverArm kArm, bool kComposed, class Pairs>
std::unique_ptr<PairLoop> loop_over(Pairs pairs) {
  return std::make_unique<GrainLoop<Pairs, kArm, kComposed>>(std::move(pairs));
}

}  // namespace

std::unique_ptr<PairLoop> make_grain_loop(const ContactParameters& parameters, LeverArm arm,
                                          SpringLimit limit, ZeroTerms zero_terms, double sphere_radius,
                                          bool composed) {
  return with_law(parameters, arm, composed, limit, zero_terms,
                  [&]<class Law, class Arm, class Composed>(std::type_identity<Law>, Arm, Composed) {
                    const Law law(parameters, effective_radius(sphere_radius, sphere_radius));
                    return loop_over<Arm::value, Composed::value>(AlikePairs<Law>(law, sphere_radius));
                  });
}

std::unique_ptr<PairLoop> make_general_grain_loop(const GeneralContact& contact, LeverArm arm,
                                                  const GrainShape& shape) {
  const double radius = shape.sphere_radius;
  laws::require_sensible(contact.grains);
  const laws::GeneralContactLaw law(contact.grains, contact.scaling,
                                    {radius, radius, shape.mass, shape.mass});
  return with_arm(arm, shape.spheres() > 1, [&]<class Arm, class Composed>(Arm, Composed) {
    return loop_over<Arm::value, Composed::value>(AlikePairs<laws::GeneralContactLaw>(law, radius));
  });
}

std::unique_ptr<PairLoop> make_mixed_grain_loop(const KindTable& kinds, const GrainMix& mix, LeverArm arm) {
  return with_arm(arm, kinds.composed(), [&]<class Arm, class Composed>(Arm, Composed) {
    if (!kinds.alike()) return loop_over<Arm::value, Composed::value>(KindPairs(kinds, mix));
    return loop_over<Arm::value, Composed::value>(
        AlikePairs<laws::GeneralContactLaw>(law_of_kinds(kinds, mix, 0, 0), kinds.shape(0).sphere_radius));
  });
}

}  // namespace diefill::engine
