// Contacts among the grains of a rank. The law, and what it makes of a batch of contacts, are the engine's
// (engine/contact/contact_batch.h).
#pragma once

#include "process/cluster/lammps/memory_record.h"
#include "process/cluster/lammps/near_pairs.h"

namespace diefill::process::cluster {

/// `Pairs`: MonodispersePairs or ClassPairs of the engine.
template <class Pairs, engine::LeverArm kArm, bool kClumps>
class GrainPass final : public ContactPass {
 public:
  GrainPass(Pairs pairs, const PowderModel& model)
      : pairs_(std::move(pairs)), classes_(static_cast<std::uint32_t>(model.types.classes().size())) {
    near_.width = Batch::kHistory;
  }

  void search(const RankGrains& grains, const NearGrains& near) override {
    near_.clear();
    for (int k = 0; k < near.count; ++k) {
      const auto grain = static_cast<std::size_t>(near.grain[k]);
      for (int n = 0; n < near.partners[grain]; ++n)
        add_pairs(grains, grain, static_cast<std::size_t>(near.first[grain][n] & kIndex));
    }
  }

  void add_forces(RankGrains& grains, ContactFigures& figures) override {
    find_touching(grains);
    for (std::size_t done = 0; done < touching_.size(); done += batch_.count) {
      batch_.count = std::min(touching_.size() - done, Batch::kLanes);
      const std::uint32_t* pairs = touching_.data() + done;
      for (std::size_t lane = 0; lane < batch_.count; ++lane)
        pack(grains, near_.pair[pairs[lane]], pairs[lane], lane);
      batch_.fill_last_group();
      const auto set = grains.model.settings.instructions;
      engine::with_instructions(set, [&] {
        engine::react<kArm, kClumps, !Pairs::kMonodisperse>(
            batch_, [&](std::size_t lane) { return pairs_.of(classes(lane)); }, set,
            grains.model.settings.time_step);
      });
      double weight[Batch::kLanes];
      for (std::size_t lane = 0; lane < batch_.count; ++lane) {
        weight[lane] = add_reactions(grains, near_.pair[pairs[lane]], lane);
        engine::store_history(static_cast<const engine::ContactBatch<Law>&>(batch_), lane,
                              near_.history_of(pairs[lane]));
        note_overlap(lane, figures.overlap);
      }
      book(batch_, weight, figures);
    }
  }

  void store_history(RankGrains& grains) const override {
    const auto sign = Law::history_signs();
    for (std::size_t p = 0; p < near_.pair.size(); ++p) {
      if (!near_.touching[p]) continue;
      const End own = end_of(grains, near_.pair[p].own), other = end_of(grains, near_.pair[p].other);
      MemoryRecord::append(grains.memory[own.grain], grains.tag[other.grain], own.number, other.number,
                           near_.history_of(p), near_.width);
      if (other.grain < grains.own)
        MemoryRecord::append(grains.memory[other.grain], grains.tag[own.grain], other.number, own.number,
                             near_.history_of(p), near_.width, sign.data());
    }
  }

  void name_contacts(const RankGrains& grains, engine::NamedContacts& named) const override {
    for (std::size_t p = 0; p < near_.pair.size(); ++p) {
      if (!near_.touching[p]) continue;
      const End own = end_of(grains, near_.pair[p].own), other = end_of(grains, near_.pair[p].other);
      // A pair with a ghost is known to both ranks, with one across a period twice to one.
      if (other.grain >= grains.own && grains.tag[own.grain] > grains.tag[other.grain]) continue;
      const auto id = [&](const End& end) { return static_cast<std::uint64_t>(grains.tag[end.grain] - 1); };
      named.pair.push_back({id(own), id(other), own.number, other.number});
      const double* history = near_.history_of(p);
      named.history.insert(named.history.end(), history, history + near_.width);
    }
  }

  std::vector<double> history_signs() const override { return Law::history_signs(); }
  bool rolls() const override { return kRolls && pairs_.rolls(); }

 private:
  using Law = typename Pairs::Law;
  using Batch = engine::ContactBatch<Law>;
  static constexpr bool kTurns = engine::Lever<kArm>::kTurns;
  static constexpr bool kRolls = !kClumps && kTurns;
  static constexpr bool kOtherDiffers =
      kTurns && (kClumps ? engine::Lever<kArm>::kOtherDiffers : static_cast<bool>(Law::kRolls));
  static constexpr int kIndex = 0x3FFFFFFF;  ///< LAMMPS keeps flags in the bits above

  /// A sphere by its grain and its number there.
  struct End {
    std::size_t grain;
    std::uint32_t number;
  };
  static End end_of(const RankGrains& grains, std::uint32_t sphere) {
    if constexpr (!kClumps) return {sphere, 0};
    const auto per_grain = static_cast<std::uint32_t>(grains.model.spheres());
    return {sphere / per_grain, sphere % per_grain};
  }
  std::uint32_t classes_of(const RankGrains& grains, const End& own, const End& other) const {
    if constexpr (Pairs::kMonodisperse) return 0;
    return grains.class_of(own.grain, own.number) * classes_ + grains.class_of(other.grain, other.number);
  }
  std::uint32_t classes(std::size_t lane) const { return Pairs::kMonodisperse ? 0 : batch_.classes[lane]; }

  /// Near pairs of the spheres of two grains.
  void add_pairs(const RankGrains& grains, std::size_t grain, std::size_t other) {
    const auto per_grain = static_cast<std::uint32_t>(grains.model.spheres());
    const double skin = grains.model.skin;
    for (std::uint32_t s = 0; s < grains.spheres_of(grain); ++s)
      for (std::uint32_t t = 0; t < grains.spheres_of(other); ++t) {
        const NearPair pair{static_cast<std::uint32_t>(grain) * per_grain + s,
                            static_cast<std::uint32_t>(other) * per_grain + t};
        const double reach =
            std::sqrt(pairs_.reach_squared(classes_of(grains, {grain, s}, {other, t}))) + skin;
        const engine::Vector3 between = grains.sphere[pair.own] - grains.sphere[pair.other];
        if (dot(between, between) > reach * reach) continue;
        near_.add(pair, MemoryRecord::find(grains.memory[grain], grains.tag[other], s, t));
      }
  }

  void find_touching(const RankGrains& grains) {
    touching_.clear();
    const engine::Vector3* sphere = grains.sphere.data();
    for (std::size_t p = 0; p < near_.pair.size(); ++p) {
      const NearPair pair = near_.pair[p];
      const engine::Vector3 between = sphere[pair.own] - sphere[pair.other];
      std::uint32_t kinds = 0;
      if constexpr (!Pairs::kMonodisperse)
        kinds = classes_of(grains, end_of(grains, pair.own), end_of(grains, pair.other));
      const bool touches = dot(between, between) < pairs_.reach_squared(kinds);
      if (touches != static_cast<bool>(near_.touching[p])) near_.note(p, touches);
      if (touches) touching_.push_back(static_cast<std::uint32_t>(p));
    }
  }

  /// Brings a pair into a lane; moments are about the centre of its first grain.
  void pack(const RankGrains& grains, NearPair pair, std::size_t p, std::size_t lane) {
    const End own = end_of(grains, pair.own), other = end_of(grains, pair.other);
    if constexpr (!Pairs::kMonodisperse) batch_.classes[lane] = classes_of(grains, own, other);
    batch_.separation.set(lane, grains.sphere[pair.own] - grains.sphere[pair.other]);
    engine::Vector3 velocity = grains.velocity_of(own.grain) - grains.velocity_of(other.grain);
    const engine::Vector3 spin = grains.spin_of(own.grain), other_spin = grains.spin_of(other.grain);
    if constexpr (kClumps) {
      const engine::Vector3 place = grains.sphere[pair.own] - grains.centre(own.grain);
      velocity +=
          cross(spin, place) - cross(other_spin, grains.sphere[pair.other] - grains.centre(other.grain));
      batch_.place.set(lane, place);
    }
    batch_.velocity.set(lane, velocity);
    batch_.spin_sum.set(lane, spin + other_spin);
    batch_.relative_spin.set(lane, spin - other_spin);
    engine::load_history(near_.history_of(p), batch_, lane);
  }

  /// Adds a lane's forces to the sums of own grains; returns the share of the pair that is this rank's.
  double add_reactions(RankGrains& grains, NearPair pair, std::size_t lane) const {
    const End own = end_of(grains, pair.own), other = end_of(grains, pair.other);
    const engine::Vector3 force = batch_.force[lane], moment = batch_.moment[lane];
    const double load = kRolls ? pairs_.of(classes(lane)).law.rolling_friction * batch_.load[lane] : 0;
    const auto add = [&](std::size_t grain, engine::Vector3 push, engine::Vector3 turn) {
      engine::ContactSum& sum = grains.sums[grain];
      sum.add_force(push);
      if constexpr (kTurns) sum.add_moment(turn);
      if constexpr (kRolls) sum.add_rolling_load(load);
    };
    add(own.grain, force, moment);
    if (other.grain >= grains.own) return 0.5;
    engine::Vector3 turn = kOtherDiffers ? batch_.other_moment[lane] : kClumps ? -moment : moment;
    if constexpr (kClumps) turn -= cross(grains.centre(own.grain) - grains.centre(other.grain), force);
    add(other.grain, -force, turn);
    return 1;
  }

  void note_overlap(std::size_t lane, engine::DeepestOverlap& deepest) const {
    const auto reach = pairs_.of(classes(lane)).reach;
    const double overlap = batch_.overlap[lane];
    deepest.grains = std::max(deepest.grains, overlap);
    const double smaller = std::min(reach.radius, reach.contact - reach.radius);
    deepest.grains_over_radius = std::max(deepest.grains_over_radius, overlap / smaller);
  }

  Pairs pairs_;
  std::uint32_t classes_;
  NearPairs near_;
  std::vector<std::uint32_t> touching_;
  Batch batch_{};
};

}  // namespace diefill::process::cluster
