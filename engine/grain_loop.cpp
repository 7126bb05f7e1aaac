#include "engine/contact_kernel.h"

namespace diefill::engine {

void BlockTally::start(std::size_t bodies) {
  viscous_work = tangential_work = drag_work = rolling_work = 0;
  overlap = {};
  touching = 0;
  body_force.assign(bodies, Eigen::Vector3d::Zero());
  body_torque.assign(bodies, Eigen::Vector3d::Zero());
}

namespace {

/// Pairs between grains. `kComposed`: several spheres a grain, moments about the block's reference point.
template <class Law, LeverArm kArm, bool kComposed>
class GrainLoop final : public PairLoop {
 public:
  /// `radius`: m, of the spheres.
  GrainLoop(Law law, double radius) : law_(std::move(law)), reach_{2 * radius, radius} {}

  void add_forces(Block& block, const ContactScene& scene, BlockTally& tally) const override {
    thread_local std::vector<std::uint32_t> touching;
    find_touching(block.grain_pairs, scene.spheres, touching);
    thread_local ContactBatch<Law> batch;
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < touching.size(); done += batch.count) {
      batch.count = std::min(touching.size() - done, ContactBatch<Law>::kLanes);
      const std::uint32_t* pairs = touching.data() + done;
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        pack(block, pairs[lane], scene.spheres, lane, batch);
      batch.fill_last_group();
      with_instructions(scene.instructions,
                        [&] { react<kArm, kComposed>(batch, law_, reach_, scene.time_step); });
      for (std::size_t lane = 0; lane < batch.count; ++lane) hand_out(batch, lane, block, pairs[lane]);
      batches.add(batch);
    }
    batches.book(scene.time_step, tally, tally.overlap.grains);
  }

  double stored_energy(const Block& block, const ContactScene& scene) const override {
    double energy = 0;
    const auto& table = block.grain_pairs;
    for (std::size_t p = 0; p < table.size(); ++p) {
      const GrainPair pair = table.pair[p];
      const double overlap =
          reach_.contact - length(scene.spheres.position[pair.own] - scene.spheres.position[pair.other]);
      if (overlap > 0) energy += law_.energy(overlap, table.memory_of(p));
    }
    return energy;
  }

  std::vector<double> memory_signs() const override { return Law::memory_signs(); }
  double range() const override { return law_.range(); }

 private:
  using Batch = ContactBatch<Law>;

  /// Distances are tested first and touching pairs collected, so that the costly part runs without guessing.
  void find_touching(PairTable<GrainPair>& table, const LocalSpheres& spheres,
                     std::vector<std::uint32_t>& touching) const {
    touching.resize(table.size());
    const double reach = reach_.contact + law_.range(), reach_squared = reach * reach;
    std::size_t count = 0;
    for (std::size_t p = 0; p < table.size(); ++p) {
      // What touching pairs remember is not looked at before all distances are known: time to fetch it.
      __builtin_prefetch(table.memory_of(p), 1, 2);
      const GrainPair pair = table.pair[p];
      const Vector3 between = spheres.position[pair.own] - spheres.position[pair.other];
      const bool touches = dot(between, between) < reach_squared;
      note_touching(table, p, touches);
      touching[count] = static_cast<std::uint32_t>(p);
      count += touches;
    }
    touching.resize(count);
  }

  void pack(const Block& block, std::uint32_t p, const LocalSpheres& spheres, std::size_t lane,
            Batch& batch) const {
    const GrainPair pair = block.grain_pairs.pair[p];
    const Vector3 here = spheres.position[pair.own];
    batch.separation.set(lane, here - spheres.position[pair.other]);
    const SphereMotion& own = spheres.motion[pair.own];
    const SphereMotion& other = spheres.motion[pair.other];
    batch.velocity.set(lane, own.velocity - other.velocity);
    if constexpr (kComposed) batch.place.set(lane, here - plain(block.reference));
    if constexpr (Lever<kArm>::kTurns) {
      batch.spin_sum.set(lane, own.spin + other.spin);
      if constexpr (Law::kRolls) batch.relative_spin.set(lane, own.spin - other.spin);
    }
    recall(block.grain_pairs, p, batch, lane);
  }

  void hand_out(const Batch& batch, std::size_t lane, Block& block, std::uint32_t p) const {
    const GrainPair pair = block.grain_pairs.pair[p];
    ContactSum& own = block.sums[block.slot[pair.own]];
    ContactSum& other = block.sums[block.slot[pair.other]];
    own.force += batch.force[lane];
    other.force -= batch.force[lane];
    if constexpr (Lever<kArm>::kTurns) {
      own.moment += batch.moment[lane];
      if constexpr (kComposed ? Lever<kArm>::kOtherDiffers : Law::kRolls)
        other.moment += batch.other_moment[lane];
      else if constexpr (kComposed)
        other.moment -= batch.moment[lane];
      else
        other.moment += batch.moment[lane];
    }
    if constexpr (!kComposed && Lever<kArm>::kTurns) {
      own.rolling_load += law_.rolling_friction * batch.load[lane];
      other.rolling_load += law_.rolling_friction * batch.load[lane];
    }
    remember(batch, lane, block.grain_pairs, p);
  }

  Law law_;
  PairReach reach_;
};

}  // namespace

std::unique_ptr<PairLoop> make_grain_loop(const ContactParameters& parameters, LeverArm arm,
                                          SpringLimit limit, double sphere_radius, bool composed) {
  return with_law(parameters, arm, limit,
                  [&]<class Law, class Arm>(std::type_identity<Law>, Arm) -> std::unique_ptr<PairLoop> {
                    const Law law(parameters, effective_radius(sphere_radius, sphere_radius));
                    if (composed)
                      return std::make_unique<GrainLoop<Law, Arm::value, true>>(law, sphere_radius);
                    return std::make_unique<GrainLoop<Law, Arm::value, false>>(law, sphere_radius);
                  });
}

std::unique_ptr<PairLoop> make_general_grain_loop(const GeneralContact& contact, LeverArm arm,
                                                  const GrainShape& shape) {
  const double radius = shape.sphere_radius;
  laws::require_sensible(contact.grains);
  const laws::GeneralContactLaw law(contact.grains, contact.scaling,
                                    {radius, radius, shape.mass, shape.mass});
  return with_arm(arm, [&]<class Arm>(Arm) -> std::unique_ptr<PairLoop> {
    if (shape.spheres() > 1)
      return std::make_unique<GrainLoop<laws::GeneralContactLaw, Arm::value, true>>(law, radius);
    return std::make_unique<GrainLoop<laws::GeneralContactLaw, Arm::value, false>>(law, radius);
  });
}

}  // namespace diefill::engine
