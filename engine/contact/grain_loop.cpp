#include <bit>

#include "engine/contact/contact_kernel.h"
#include "engine/contact/contact_workspace.h"
#include "engine/contact/grain_batch.h"
#include "engine/contact/pair_distances.h"
#include "engine/contact/pair_laws.h"
#include "engine/numerics/prefetch.h"
#include "engine/numerics/vector_width.h"

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
    touching[std::popcount(touches.now & up_to_lowest(begun)) - 1].history = GrainPairTable::kNothing;
}

/// Pairs between grains. `Pairs`: which law acts between which. `kClumps`: several spheres per grain, moments
/// about the block's reference point.
template <class Pairs, LeverArm kArm, bool kClumps>
class GrainLoop final : public PairLoop {
 public:
  explicit GrainLoop(Pairs pairs) : pairs_(std::move(pairs)) {}

  void add_forces(Block& block, const ContactScene& scene, ContactWorkspace& workspace,
                  BlockTally& tally) const override {
    // Contacts begin and end: histories are written again in every step, closely packed.
    std::vector<double>& next_history = workspace.next_history;
    std::vector<TouchingPair>& touching = workspace.touching;
    GrainPairTable& table = block.grain_pairs;
    touching.resize(table.size());
    std::size_t count = 0;
    with_width(scene.instructions, [&](auto wide) {
      count = find_touching<decltype(wide)::value>(block, scene.spheres, touching.data());
    });
    table.make_room_for_history(next_history, count);
    Batch batch;
    if constexpr (!kTurns && Law::kRolls) batch.set_no_spins();
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < count; done += batch.count) {
      batch.count = std::min(count - done, Batch::kLanes);
      std::copy_n(touching.data() + done, batch.count, batch.pair);
      double* history = next_history.data() + (done + 1) * table.width;
      with_width(scene.instructions, [&](auto wide) {
        constexpr bool kWide = decltype(wide)::value;
        pack<kWide>(block, scene.spheres, batch);
        react_all(batch, scene.instructions, scene.time_step);
        add_reactions<kWide>(batch, block, workspace.sums);
        batch.template write_history<kWide>(history);
        batches.add(batch);
      });
      if constexpr (!Pairs::kMonodisperse)
        batches.add_over_radius(batch, [&](std::size_t lane) { return smaller_radius(batch.classes[lane]); });
    }
    table.keep_history(next_history);
    batches.add_to(tally, scene.time_step);
    tally.overlap.grains = std::max(tally.overlap.grains, batches.deepest());
    const double over_radius =
        Pairs::kMonodisperse ? batches.deepest() / smaller_radius(0) : batches.deepest_over_radius();
    tally.overlap.grains_over_radius = std::max(tally.overlap.grains_over_radius, over_radius);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    Batch batch;
    if constexpr (!kTurns && Law::kRolls) batch.set_no_spins();
    const GrainPairTable& table = block.grain_pairs;
    std::uint32_t place = GrainPairTable::kNothing;
    batch.count = 0;
    const auto visit_batch = [&] {
      if (batch.count == 0) return;
      pack<false>(block, scene.spheres, batch);
      react_all(batch, scene.instructions, 0);
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = batch.pair[lane].pair;
        const Vector3 separation = batch.separation[lane];
        const double radius = pairs_.of(pair_classes(batch, lane)).reach.radius;
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
      const double* history = table.history_at(table.touching[p] ? place : GrainPairTable::kNothing);
      const auto [law, reach] = pairs_.of(pairs_.classes(block, pair));
      const double overlap =
          reach.contact - length(scene.spheres.position(pair.own) - scene.spheres.position(pair.other));
      if (overlap > 0) energy += law.energy(overlap, history);
    }
    return energy;
  }

  std::vector<double> history_signs() const override { return Law::history_signs(); }
  std::vector<HistoryLayout> history_layouts() const override { return pairs_.history_layouts(); }
  void clear_changed_history(Block& block, const std::vector<HistoryLayout>& next) const override {
    const auto before = history_layouts();
    GrainPairTable& table = block.grain_pairs;
    table.change_touching([&](std::size_t p, double* history) {
      const std::size_t law = pairs_.law_number(block, table.pair[p]);
      clear_changed(history, before[law], next[law]);
    });
  }
  bool rolls() const override { return kRolls && pairs_.rolls(); }
  double range() const override { return pairs_.range(); }

 private:
  using Law = typename Pairs::Law;
  using Batch = GrainBatch<Law>;

  static constexpr std::size_t kTested = 64;  ///< pairs at a time
  static constexpr bool kTurns = Lever<kArm>::kTurns;
  /// Loads count where single spheres roll.
  static constexpr bool kRolls = !kClumps && kTurns;
  /// Whether the reaction on j is not the one on i with other signs.
  static constexpr bool kOtherDiffers =
      kTurns && (kClumps ? Lever<kArm>::kOtherDiffers : static_cast<bool>(Law::kRolls));
  static_assert(Pairs::kMonodisperse || Law::kRolls, "unequal radii need the relative spin of a pair");

  static std::uint32_t pair_classes(const Batch& batch, std::size_t lane) {
    return Pairs::kMonodisperse ? 0 : batch.classes[lane];
  }
  /// m, of the pair's two spheres.
  double smaller_radius(std::uint32_t classes) const {
    const PairReach reach = pairs_.of(classes).reach;
    return Pairs::kMonodisperse ? reach.radius : std::min(reach.radius, reach.contact - reach.radius);
  }

  void react_all(Batch& batch, InstructionSet instructions, double time_step) const {
    if constexpr (kClumps) bring_velocities_to_centres(batch);
    react<kArm, kClumps, !Pairs::kMonodisperse>(
        batch, [&](std::size_t lane) { return pairs_.of(pair_classes(batch, lane)); }, instructions,
        time_step);
  }

  /// Distances are tested first and touching pairs collected, so that the costly part runs without guessing.
  /// Returns how many were written to `touching`.
  template <bool kWide>
  std::size_t find_touching(Block& block, const LocalSpheres& spheres, TouchingPair* touching) const {
    GrainPairTable& table = block.grain_pairs;
    std::size_t count = 0;
    std::uint32_t before = 0;  // pairs so far that touched in the last step
    const auto test = [&](std::size_t first, auto how_many) {
      const GrainPair* near = table.pair.data() + first;
      prefetch<kTested>(first, table.pair, table.touching);
      const Touches touches = test_some<kWide>(block, spheres, near, how_many, table.touching.data() + first);
      list_touching(near, touches, before, touching + count);
      // Batches are too short for the processor to see that histories are read in a row.
      table.fetch_history(before + 1, static_cast<std::size_t>(std::popcount(touches.last)));
      count += static_cast<std::size_t>(std::popcount(touches.now));
      before += static_cast<std::uint32_t>(std::popcount(touches.last));
    };
    std::size_t first = 0;
    for (; first + kTested <= table.size(); first += kTested)
      test(first, std::integral_constant<std::size_t, kTested>{});
    if (first < table.size()) test(first, table.size() - first);
    return count;
  }

  /// Notes in `touches` which of the near pairs touch, `how_many` of them, known to the compiler or not.
  template <bool kWide, class Count>
  Touches test_some(const Block& block, const LocalSpheres& spheres, const GrainPair* near, Count how_many,
                    std::uint8_t* touches) const {
    double square[kTested];
    measure<kWide>(spheres, near, how_many, square);
    std::uint8_t last[kTested] = {}, now[kTested] = {};
    std::copy_n(touches, std::size_t{how_many}, last);
    if constexpr (Pairs::kMonodisperse) {
      const double reach_squared = pairs_.reach_squared(0);
      for (std::size_t k = 0; k < how_many; ++k) now[k] = square[k] < reach_squared;
    } else {
      for (std::size_t k = 0; k < how_many; ++k)
        now[k] = square[k] < pairs_.reach_squared(pairs_.classes(block, near[k]));
    }
    std::copy_n(now, std::size_t{how_many}, touches);
    Touches tested{0, 0};
    for (std::size_t k = 0; k < kTested; k += 8) {
      tested.last |= bits_from_bytes(last + k) << k;
      tested.now |= bits_from_bytes(now + k) << k;
    }
    return tested;
  }

  /// Squares (m^2) of the distances of some near pairs.
  template <bool kWide>
  static void measure(const LocalSpheres& spheres, const GrainPair* near, std::size_t count, double* square) {
    std::size_t k = 0;
    if constexpr (kWide) {
      const std::size_t whole = count / 4 * 4;
      for (; k < whole; k += 4)
        squares_of_four(
            [&](int lane, Four& between) {
              spheres.separate(near[k + static_cast<std::size_t>(lane)], between);
            },
            square + k);
    }
    for (; k < count; ++k) {
      const Vector3 between = spheres.position(near[k].own) - spheres.position(near[k].other);
      square[k] = dot(between, between);
    }
  }

  /// Brings the batch's pairs into its lanes, whole groups of them: the last pair fills up.
  template <bool kWide>
  void pack(const Block& block, const LocalSpheres& spheres, Batch& batch) const {
    batch.fill_last_group();
    if constexpr (!Pairs::kMonodisperse)
      for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane)
        batch.classes[lane] = pairs_.classes(block, batch.pair[lane].pair);
    batch.template fill_separations<kWide>(spheres);
    batch.template fill_history<kWide>(block.grain_pairs);
    batch.template fill_motion<kWide, kClumps, kClumps || (kTurns && Law::kRolls)>(block, spheres);
    if constexpr (kClumps)
      for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane)
        batch.place.set(lane, spheres.position(batch.pair[lane].pair.own) - plain(block.reference));
  }

  /// m, what loads are multiplied by for rolling friction against the grains' own spins; where types differ,
  /// the loads of the lanes have become torques already.
  double rolling_factor(Batch& batch) const {
    if constexpr (!kRolls) return 0;
    if constexpr (Pairs::kMonodisperse) return pairs_.of(0).law.rolling_friction;
    for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane)
      batch.load[lane] *= pairs_.of(batch.classes[lane]).law.rolling_friction;
    return 1;
  }

  /// Adds the batch's forces to `sums`.
  template <bool kWide>
  void add_reactions(Batch& batch, const Block& block, std::vector<ContactSum>& sums) const {
    const double rolling = rolling_factor(batch);
    constexpr double kTurn = kClumps && !kOtherDiffers ? -1 : 1;
    if constexpr (kWide) {
      constexpr Four kForceOnOther{-1, -1, -1, 1}, kMomentOnOther{kTurn, kTurn, kTurn, kTurn};
      batch.template for_reactions<kTurns, kOtherDiffers>(
          rolling, [&](GrainPair pair, const auto& own, const auto& other) {
            const auto add = [&](LocalSphere sphere, const Four& push, const Four& turn) {
              ContactSum& sum = sums[block.slot_of<kClumps>(sphere)];
              add_to(sum.first_half(), push);
              if constexpr (kTurns) add_to(sum.second_half(), turn);
            };
            add(pair.own, own.push, own.turn);
            add(pair.other, kForceOnOther * other.push, kMomentOnOther * other.turn);
          });
    } else {
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = batch.pair[lane].pair;
        const Vector3 force = batch.force[lane];
        const auto add = [&](LocalSphere sphere, Vector3 push, Vector3 moment) {
          ContactSum& sum = sums[block.slot_of<kClumps>(sphere)];
          sum.add_force(push);
          if constexpr (kTurns) sum.add_moment(moment);
          if constexpr (kRolls) sum.add_rolling_load(rolling * batch.load[lane]);
        };
        add(pair.own, force, batch.moment[lane]);
        add(pair.other, -force, kOtherDiffers ? batch.other_moment[lane] : kTurn * batch.moment[lane]);
      }
    }
  }

  Pairs pairs_;
};

/// The loop over `pairs`.
template <LeverArm kArm, bool kClumps, class Pairs>
std::unique_ptr<PairLoop> loop_over(Pairs pairs) {
  return std::make_unique<GrainLoop<Pairs, kArm, kClumps>>(std::move(pairs));
}

/// The tuned loop of grains of one type.
std::unique_ptr<PairLoop> make_tuned_loop(const laws::BierwischLaw& law, const ParticleTypes& types,
                                          LeverArm arm) {
  const double radius = types.shape(0).sphere_radius;
  return with_law(law.parameters, arm, types.clumps(), law.spring_limit,
                  [&]<class Law, class Arm, class Clumps>(std::type_identity<Law>, Arm, Clumps) {
                    return loop_over<Arm::value, Clumps::value>(MonodispersePairs<Law>(
                        Law(law.parameters, effective_radius(radius, radius)), radius));
                  });
}

}  // namespace

std::unique_ptr<PairLoop> make_grain_loop(const ParticleTypes& types, const ContactLaws& contact,
                                          LeverArm arm) {
  if (const auto tuned = tuned_law(types, contact, types.material(0)))
    return make_tuned_loop(*tuned, types, arm);
  return with_arm(arm, types.clumps(), [&]<class Arm, class Clumps>(Arm, Clumps) {
    if (types.classes().size() > 1) return loop_over<Arm::value, Clumps::value>(ClassPairs(types, contact));
    return loop_over<Arm::value, Clumps::value>(MonodispersePairs<laws::GeneralContactLaw>(
        law_between(types, contact, 0, 0), types.shape(0).sphere_radius));
  });
}

}  // namespace diefill::engine
