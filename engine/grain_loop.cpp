#include "engine/contact_kernel.h"
#include "engine/grain_batch.h"
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
    GrainPairTable& table = block.grain_pairs;
    table.make_room_to_remember(remembered);
    Batch& batch = batch_of_thread<Batch>();
    BatchTally<Law> batches;
    std::size_t touching = 0;
    for (Progress progress; progress.pair < table.size();) {
      with_instructions(scene.instructions, [&] { find_touching(block, scene.spheres, progress, batch); });
      if (batch.count == 0) break;
      double* memory = remembered.data() + (touching + 1) * table.width;
      with_instructions(scene.instructions, [&] {
        pack(block, scene.spheres, batch);
        react_all(batch, scene.time_step);
        hand_out(batch, block, sums);
        batch.write_memory(memory);
        batches.add(batch);
      });
      if constexpr (!Pairs::kAlike)
        batches.add_over_radius(batch, [&](std::size_t lane) { return smaller_radius(batch.kinds[lane]); });
      touching += batch.count;
    }
    table.keep(remembered, touching);
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
    const typename Batch::Source source(scene.spheres, table);
    std::uint32_t place = GrainPairTable::kNothing;
    batch.count = 0;
    const auto visit_batch = [&] {
      if (batch.count == 0) return;
      pack(block, scene.spheres, batch);
      react_all(batch, 0);
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const GrainPair pair = batch.pair[lane];
        const Vector3 separation = batch.separation[lane];
        const double radius = pairs_.of(kinds_of(batch, lane)).reach.radius;
        const double share = (radius - 0.5 * batch.overlap[lane]) / length(separation);
        visit(
            {pair.own, pair.other, batch.force[lane], scene.spheres.position(pair.own) - share * separation});
      }
      batch.count = 0;
    };
    table.visit_touching([&](std::size_t p, const double*) {
      note(batch.count, block, source, table.pair[p], ++place, batch);
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

  /// How far a block's near pairs have been looked at.
  struct Progress {
    std::size_t pair = 0;
    std::uint32_t touched = 0;  ///< how many of them touched in the last step
  };

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

  /// Notes a pair as number `lane` of the batch. Returns the square of its distance.
  double note(std::size_t lane, const Block& block, const typename Batch::Source& source,
              const GrainPair& pair,              std::uint32_t place, Batch& batch) const {
    if constexpr (!Pairs::kAlike) batch.kinds[lane] = pairs_.kinds(block, pair);
    return batch.note(lane, pair, source, place);
  }

  /// Goes on through the near pairs until the batch is full of touching ones.
  void find_touching(Block& block, const LocalSpheres& spheres, Progress& progress, Batch& batch) const {
    const GrainPairTable& table = block.grain_pairs;
    table.fetch_memory(progress.touched + Batch::kLanes, Batch::kLanes);
    const typename Batch::Source source(spheres, table);
    const GrainPair* pair = table.pair.data();
    std::uint8_t* touching = block.grain_pairs.touching.data();
    const double alike_reach = Pairs::kAlike ? pairs_.reach_squared(0) : 0;
    std::size_t p = progress.pair, count = 0;
    std::uint32_t touched = progress.touched;
    for (const std::size_t all = table.size(); p < all && count < Batch::kLanes; ++p) {
      const std::uint32_t did_touch = touching[p];
      touched += did_touch;
      const double squared = note(count, block, source, pair[p], touched * did_touch, batch);
      // Whether a near pair touches cannot be guessed: no branch depends on it, the next overwrites it.
      const bool touches = squared < (Pairs::kAlike ? alike_reach : pairs_.reach_squared(batch.kinds[count]));
      count += touches;
      touching[p] = touches;
    }
    progress = {p, touched};
    batch.count = count;
  }

  /// Brings the batch's pairs into its lanes, whole groups of them: the last pair fills up.
  void pack(const Block& block, const LocalSpheres& spheres, Batch& batch) const {
    batch.fill_last_group();
    batch.spread_between(block.grain_pairs);
    batch.template spread_motion<kComposed>(block, spheres);
    if constexpr (kComposed || (kTurns && Law::kRolls))
      for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane) {
        const GrainPair pair = batch.pair[lane];
        if constexpr (kComposed) batch.place.set(lane, spheres.position(pair.own) - plain(block.reference));
        batch.relative_spin.set(lane, spheres.spin(block.slot_of<kComposed>(pair.own)) -
                                          spheres.spin(block.slot_of<kComposed>(pair.other)));
      }
  }

  /// Adds the batch's forces to `sums`.
  void hand_out(const Batch& batch, const Block& block, std::vector<ContactSum>& sums) const {
    const double rolling = kRolls ? pairs_.rolling_friction() : 0;
    const Eight own_sign = {1, 1, 1, 1, 1, 1, rolling, 0};
    const double turn = kComposed && !kOtherDiffers ? -1 : 1;
    const Eight other_sign = {-1, -1, -1, turn, turn, turn, rolling, 0};
    batch.template for_reactions<kTurns>(batch.moment, [&](std::size_t lane, const Eight& reaction) {
      add_times(sums[block.slot_of<kComposed>(batch.pair[lane].own)].data(), reaction, own_sign);
      if constexpr (!kOtherDiffers)
        add_times(sums[block.slot_of<kComposed>(batch.pair[lane].other)].data(), reaction, other_sign);
    });
    if constexpr (kOtherDiffers)
      batch.template for_reactions<kTurns>(batch.other_moment, [&](std::size_t lane, const Eight& reaction) {
        add_times(sums[block.slot_of<kComposed>(batch.pair[lane].other)].data(), reaction, other_sign);
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
