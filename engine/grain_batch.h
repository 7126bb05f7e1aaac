// Touching pairs of grains on their way into a batch's lanes and out of them: pairs are read and written as
// records, eight of which turn into lanes in registers.
#pragma once

#include <type_traits>

#include "engine/contact_batch.h"
#include "engine/local_spheres.h"
#include "engine/pair_table.h"
#include "engine/transpose.h"

namespace diefill::engine {

/// A touching pair, and where the table has what it remembered before this step.
struct TouchingPair {
  GrainPair pair;
  std::uint32_t memory;
};

/// A batch of pairs between grains.
template <class Law>
struct GrainBatch : ContactBatch<Law> {
  using Base = ContactBatch<Law>;
  using Base::kLanes, Base::kMemory, Base::count;

  /// Whether a record has room for what a pair remembers: in its upper half.
  static constexpr bool kMemoryInRecord = kMemory <= 4;
  static constexpr std::size_t kUpper = 4;

  TouchingPair pair[kLanes];

  /// Repeats the last pair until a whole group is full.
  void fill_last_group() {
    for (std::size_t lane = count; lane < whole_groups(count); ++lane) {
      pair[lane] = pair[count - 1];
      this->kinds[lane] = this->kinds[count - 1];
    }
  }

  /// Fills the lanes of separations and of what the pairs remember in `table`. `kWide`, here and below: by
  /// way of records.
  template <bool kWide>
  void spread_between(const LocalSpheres& spheres, const GrainPairTable& table) {
    if constexpr (kWide)
      for (std::size_t k = 0; k < whole_groups(count); k += kLaneGroup) spread_eight(k, spheres, table);
    else
      for (std::size_t lane = 0; lane < whole_groups(count); ++lane)
        this->separation.set(lane,
                             spheres.position(pair[lane].pair.own) - spheres.position(pair[lane].pair.other));
    if constexpr (!kWide || !kMemoryInRecord)
      for (std::size_t lane = 0; lane < whole_groups(count); ++lane) {
        const double* remembered = table.memory_at(pair[lane].memory);
        for (std::size_t n = 0; n < kMemory; ++n) this->memory[n][lane] = remembered[n];
      }
  }

  /// Fills the lanes of motions: velocities are subtracted, spins added.
  template <bool kWide, bool kComposed>
  void spread_motion(const Block& block, const LocalSpheres& spheres) {
    if constexpr (kWide) {
      for (std::size_t k = 0; k < whole_groups(count); k += kLaneGroup)
        spread_motion_of_eight<kComposed>(k, block, spheres);
    } else {
      for (std::size_t lane = 0; lane < whole_groups(count); ++lane) {
        const std::size_t own = block.slot_of<kComposed>(pair[lane].pair.own),
                          other = block.slot_of<kComposed>(pair[lane].pair.other);
        this->velocity.set(lane, spheres.velocity(own) - spheres.velocity(other));
        this->spin_sum.set(lane, spheres.spin(own) + spheres.spin(other));
      }
    }
  }

  /// Writes what the pairs remember to `remembered`, one pair after the other. Up to three numbers behind the
  /// last are overwritten as well.
  template <bool kWide>
  void write_memory(double* remembered) const {
    if constexpr (!kWide || !kMemoryInRecord) {
      for (std::size_t lane = 0; lane < count; ++lane)
        for (std::size_t n = 0; n < kMemory; ++n) remembered[lane * kMemory + n] = this->memory[n][lane];
    } else if constexpr (kMemory > 0) {
      in_groups([&](std::size_t k, auto pairs) {
        Records records{};
        for (std::size_t n = 0; n < kMemory; ++n) records.load(n, this->memory[n].value + k);
        records.transpose();
        for (std::size_t lane = 0; lane < pairs; ++lane)
          __builtin_memcpy(remembered + (k + lane) * kMemory, &records.row[lane], sizeof(Four));
      });
    }
  }

  /// Calls add(pair, reaction on i, reaction on j) for every pair: force, moment and load as in ContactSum.
  /// The force on j is that on i, and so is its moment unless `kOtherDiffers`. `kTurns`: whether there are
  /// moments.
  template <bool kTurns, bool kOtherDiffers, class Add>
  void for_reactions(const Add& add) const {
    in_groups([&](std::size_t k, auto pairs) {
      Records own{}, other{};
      load_reactions<kTurns>(k, this->moment, own);
      own.transpose();
      if constexpr (kOtherDiffers) {
        load_reactions<kTurns>(k, this->other_moment, other);
        other.transpose();
      }
      for (std::size_t lane = 0; lane < pairs; ++lane)
        add(pair[k + lane].pair, own.row[lane], kOtherDiffers ? other.row[lane] : own.row[lane]);
    });
  }

 private:
  void spread_eight(std::size_t k, const LocalSpheres& spheres, const GrainPairTable& table) {
    Records records;
    for (std::size_t lane = 0; lane < kLaneGroup; ++lane) {
      const TouchingPair& touching = pair[k + lane];
      Four own, other, numbers{};
      __builtin_memcpy(&own, spheres.centre(touching.pair.own).value, sizeof own);
      __builtin_memcpy(&other, spheres.centre(touching.pair.other).value, sizeof other);
      if constexpr (kMemoryInRecord && kMemory > 0)
        __builtin_memcpy(&numbers, table.memory_at(touching.memory), sizeof numbers);
      own -= other;
      records.row[lane] = __builtin_shufflevector(own, numbers, 0, 1, 2, 3, 4, 5, 6, 7);
    }
    records.transpose();
    records.store(0, &this->separation.x[k]);
    records.store(1, &this->separation.y[k]);
    records.store(2, &this->separation.z[k]);
    if constexpr (kMemoryInRecord)
      for (std::size_t n = 0; n < kMemory; ++n) records.store(kUpper + n, &this->memory[n][k]);
  }

  template <bool kComposed>
  void spread_motion_of_eight(std::size_t k, const Block& block, const LocalSpheres& spheres) {
    constexpr Eight kSign = {-1, -1, -1, -1, 1, 1, 1, 1};
    Records records;
    for (std::size_t lane = 0; lane < kLaneGroup; ++lane) {
      Eight own, other;
      take(own, spheres.motion(block.slot_of<kComposed>(pair[k + lane].pair.own)));
      take(other, spheres.motion(block.slot_of<kComposed>(pair[k + lane].pair.other)));
      records.row[lane] = own + kSign * other;
    }
    records.transpose();
    records.store(0, &this->velocity.x[k]);
    records.store(1, &this->velocity.y[k]);
    records.store(2, &this->velocity.z[k]);
    records.store(kUpper, &this->spin_sum.x[k]);
    records.store(kUpper + 1, &this->spin_sum.y[k]);
    records.store(kUpper + 2, &this->spin_sum.z[k]);
  }

  template <bool kTurns>
  void load_reactions(std::size_t k, const typename Base::Vectors& turning, Records& records) const {
    records.load(0, this->force.x.value + k);
    records.load(1, this->force.y.value + k);
    records.load(2, this->force.z.value + k);
    if constexpr (!kTurns) return;
    records.load(3, turning.x.value + k);
    records.load(4, turning.y.value + k);
    records.load(5, turning.z.value + k);
    records.load(6, this->load.value + k);
  }

  /// Calls use(first, how many) for groups of pairs; the compiler knows how many but for the last group.
  template <class Use>
  void in_groups(const Use& use) const {
    std::size_t k = 0;
    for (; k + kLaneGroup <= count; k += kLaneGroup)
      use(k, std::integral_constant<std::size_t, kLaneGroup>{});
    if (k < count) use(k, count - k);
  }
};

}  // namespace diefill::engine
