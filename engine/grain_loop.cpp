#include "engine/contact_kernel.h"
#include "engine/pair_laws.h"

namespace diefill::engine {

void BlockTally::start(std::size_t bodies) {
  viscous_work = tangential_work = drag_work = rolling_work = 0;
  overlap = {};
  touching = 0;
  body_force.assign(bodies, Eigen::Vector3d::Zero());
  body_torque.assign(bodies, Eigen::Vector3d::Zero());
}

namespace {

/// A touching pair's number in its table, and where the table has what it remembered before this step.
struct TouchingPair {
  std::uint32_t pair, memory;
};

/// Pairs between grains. `Pairs`: which law acts between which. `kComposed`: several spheres a grain, moments
/// about the block's reference point.
template <class Pairs, LeverArm kArm, bool kComposed>
class GrainLoop final : public PairLoop {
 public:
  explicit GrainLoop(Pairs pairs) : pairs_(std::move(pairs)) {}

  void add_forces(Block& block, const ContactScene& scene, std::vector<ContactSum>& sums,
                  BlockTally& tally) const override {
    thread_local std::vector<TouchingPair> touching;
    // Contacts begin and end: what pairs remember is written anew in every step, closely packed, into memory
    // that was another block's before.
    thread_local std::vector<double> remembered;
    GrainPairTable& table = block.grain_pairs;
    touching.resize(table.size());
    std::size_t count = 0;
    with_instructions(scene.instructions,
                      [&] { count = find_touching(block, scene.spheres, touching.data()); });
    make_memory(remembered, count, table.width);
    Batch& batch = batch_of_thread<Batch>();
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < count; done += batch.count) {
      batch.count = std::min(count - done, Batch::kLanes);
      const TouchingPair* pairs = touching.data() + done;
      double* memory = remembered.data() + (done + 1) * table.width;
      with_instructions(scene.instructions, [&] {
        pack(block, pairs, scene.spheres, batch);
        react_all(batch, scene.time_step);
        hand_out(batch, pairs, block, sums, memory);
        batches.add(batch);
      });
      if constexpr (!Pairs::kAlike)
        batches.add_over_radius(batch, [&](std::size_t lane) { return smaller_radius(batch.kinds[lane]); });
    }
    table.memory.swap(remembered);
    batches.book(scene.time_step, tally);
    tally.overlap.grains = std::max(tally.overlap.grains, batches.deepest());
    const double over_radius =
        Pairs::kAlike ? batches.deepest() / smaller_radius(0) : batches.deepest_over_radius();
    tally.overlap.grains_over_radius = std::max(tally.overlap.grains_over_radius, over_radius);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    std::vector<TouchingPair> touching;
    block.grain_pairs.visit_touching([&](std::size_t p, const double*) {
      touching.push_back({static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(touching.size() + 1)});
    });
    Batch& batch = batch_of_thread<Batch>();
    for (std::size_t done = 0; done < touching.size(); done += batch.count) {
      batch.count = std::min(touching.size() - done, Batch::kLanes);
      const TouchingPair* pairs = touching.data() + done;
      pack(block, pairs, scene.spheres, batch);
      react_all(batch, 0);
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = block.grain_pairs.pair[pairs[lane].pair];
        const Vector3 separation = batch.separation[lane];
        const double radius = pairs_.of(kinds_of(batch, lane)).reach.radius;
        const double share = (radius - 0.5 * batch.overlap[lane]) / length(separation);
        visit(
            {pair.own, pair.other, batch.force[lane], scene.spheres.position(pair.own) - share * separation});
      }
    }
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
  using Batch = ContactBatch<Law>;

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
  std::size_t find_touching(Block& block, const LocalSpheres& spheres, TouchingPair* touching) const {
    GrainPairTable& table = block.grain_pairs;
    std::size_t count = 0;
    std::uint32_t before = 0;  // pairs so far that touched in the last step
    const double alike_reach = Pairs::kAlike ? pairs_.reach_squared(0) : 0;
    for (std::size_t p = 0; p < table.size(); ++p) {
      // What touching pairs remember is not looked at before all distances are known: time to fetch it.
      __builtin_prefetch(table.memory_at(before), 0, 2);
      const GrainPair pair = table.pair[p];
      const Vector3 between = spheres.position(pair.own) - spheres.position(pair.other);
      const double reach_squared =
          Pairs::kAlike ? alike_reach : pairs_.reach_squared(pairs_.kinds(block, pair));
      const bool touches = dot(between, between) < reach_squared;
      // Whether a near pair touches cannot be guessed: no branch depends on it.
      const std::uint32_t touched = table.touching[p];
      before += touched;
      touching[count] = {static_cast<std::uint32_t>(p), before * touched};
      count += touches;
      table.touching[p] = touches;
    }
    return count;
  }

  /// Brings the batch's pairs into its lanes, whole groups of them: the last pair fills up.
  void pack(const Block& block, const TouchingPair* pairs, const LocalSpheres& spheres, Batch& batch) const {
    const std::size_t lanes = whole_groups(batch.count);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const TouchingPair touching = pairs[std::min(lane, batch.count - 1)];
      const GrainPair pair = block.grain_pairs.pair[touching.pair];
      const double* memory = block.grain_pairs.memory_at(touching.memory);
      if constexpr (!Pairs::kAlike) batch.kinds[lane] = pairs_.kinds(block, pair);
      const auto &here = spheres.centre(pair.own), &there = spheres.centre(pair.other);
      Record& between = batch.between[lane];
      for (std::size_t k = 0; k < 4; ++k) between.value[k] = here.value[k] - there.value[k];
      if constexpr (Batch::kMemoryInRecord)
        for (std::size_t k = 0; k < Batch::kMemory; ++k) between.value[3 + k] = memory[k];
      else
        recall(memory, batch, lane);
      // Velocities are subtracted, spins added.
      constexpr double kSign[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
      const std::size_t own_slot = block.slot_of<kComposed>(pair.own),
                        other_slot = block.slot_of<kComposed>(pair.other);
      const Record &own = spheres.motion(own_slot), &other = spheres.motion(other_slot);
      for (std::size_t k = 0; k < 8; ++k)
        batch.moving[lane].value[k] = own.value[k] + kSign[k] * other.value[k];
      if constexpr (kComposed) batch.place.set(lane, spheres.position(pair.own) - plain(block.reference));
      if constexpr (kComposed || (kTurns && Law::kRolls))
        batch.relative_spin.set(lane, spheres.spin(own_slot) - spheres.spin(other_slot));
    }
    batch.spread_records(lanes);
  }

  /// Adds the batch's forces to `sums` and writes what its pairs remember to `memory`.
  void hand_out(Batch& batch, const TouchingPair* pairs, const Block& block, std::vector<ContactSum>& sums,
                double* memory) const {
    const std::size_t lanes = whole_groups(batch.count);
    if constexpr (kTurns)
      batch.collect_records(lanes, batch.moment, batch.on_own);
    else
      batch.collect_forces(lanes);
    if constexpr (kOtherDiffers) batch.collect_records(lanes, batch.other_moment, batch.on_other);
    const double rolling = kRolls ? pairs_.rolling_friction() : 0;
    const Eight own_sign = {1, 1, 1, 1, 1, 1, rolling, 0};
    const double turn = kComposed && !kOtherDiffers ? -1 : 1;
    const Eight other_sign = {-1, -1, -1, turn, turn, turn, rolling, 0};
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
      const GrainPair pair = block.grain_pairs.pair[pairs[lane].pair];
      add_times(sums[block.slot_of<kComposed>(pair.own)].data(), batch.on_own[lane], own_sign);
      add_times(sums[block.slot_of<kComposed>(pair.other)].data(),
                kOtherDiffers ? batch.on_other[lane] : batch.on_own[lane], other_sign);
      remember(batch, lane, memory + lane * Batch::kMemory);
    }
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
