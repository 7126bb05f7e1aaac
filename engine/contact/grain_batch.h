// Packs touching grain pairs into the lanes of a batch and unpacks them again: pairs are read and written as
// records, four of which are transposed to lanes in registers.
#pragma once

#include <type_traits>

#include "engine/contact/contact_batch.h"
#include "engine/contact/local_spheres.h"
#include "engine/contact/touching_pair.h"
#include "engine/numerics/transpose.h"

namespace diefill::engine {

/// A batch of pairs between grains. `kWide`, here and below: by way of records; otherwise number by number.
template <class Law>
struct GrainBatch : ContactBatch<Law> {
  using Base = ContactBatch<Law>;
  using Base::kLanes, Base::count;
  static constexpr std::size_t kHistory = Base::kHistory;

  /// Whether a record has room for a pair's contact history.
  static constexpr bool kHistoryInRecord = kHistory > 0 && kHistory <= Records::kCount;

  TouchingPair pair[kLanes];

  /// Repeats the last pair until a whole group is full.
  void fill_last_group() {
    for (std::size_t lane = count; lane < whole_groups(count); ++lane) {
      pair[lane] = pair[count - 1];
      this->classes[lane] = this->classes[count - 1];
    }
  }

  /// Fills the lanes of separations.
  template <bool kWide>
  void fill_separations(const LocalSpheres& spheres) {
    for_lanes<kWide>([&](std::size_t k, auto several) {
      if constexpr (several) {
        Records apart;
        for (std::size_t lane = 0; lane < Records::kCount; ++lane)
          spheres.separate(pair[k + lane].pair, apart.row[lane]);
        to_vectors(apart, this->separation, k);
      } else {
        this->separation.set(k, spheres.position(pair[k].pair.own) - spheres.position(pair[k].pair.other));
      }
    });
  }

  /// Fills the lanes of contact history from `table`.
  template <bool kWide>
  void fill_history(const GrainPairTable& table) {
    for_lanes<kWide && kHistoryInRecord>([&](std::size_t k, auto several) {
      if constexpr (several) {
        Records numbers;
        for (std::size_t lane = 0; lane < Records::kCount; ++lane)
          load(numbers.row[lane], table.history_at(pair[k + lane].history));
        numbers.transpose();
        for (std::size_t n = 0; n < kHistory; ++n) numbers.to_lanes(n, &this->history[n][k]);
      } else {
        const double* stored = table.history_at(pair[k].history);
        for (std::size_t n = 0; n < kHistory; ++n) this->history[n][k] = stored[n];
      }
    });
  }

  /// Fills the lanes of motions: velocities are subtracted, spins added and, where `kRelative`, subtracted.
  template <bool kWide, bool kClumps, bool kRelative>
  void fill_motion(const Block& block, const LocalSpheres& spheres) {
    const auto own = [&](std::size_t lane) { return block.slot_of<kClumps>(pair[lane].pair.own); };
    const auto other = [&](std::size_t lane) { return block.slot_of<kClumps>(pair[lane].pair.other); };
    for_lanes<kWide>([&](std::size_t k, auto several) {
      if constexpr (several) {
        Records approach, sum, difference;
        for (std::size_t lane = 0; lane < Records::kCount; ++lane) {
          const double* of_own = spheres.motion(own(k + lane)).value;
          const double* of_other = spheres.motion(other(k + lane)).value;
          Four a, b, spin_a, spin_b;
          load(a, of_own);
          load(b, of_other);
          load(spin_a, of_own + Record::kHalf);
          load(spin_b, of_other + Record::kHalf);
          approach.row[lane] = a - b;
          sum.row[lane] = spin_a + spin_b;
          if constexpr (kRelative) difference.row[lane] = spin_a - spin_b;
        }
        to_vectors(approach, this->velocity, k);
        to_vectors(sum, this->spin_sum, k);
        if constexpr (kRelative) to_vectors(difference, this->relative_spin, k);
      } else {
        this->velocity.set(k, spheres.velocity(own(k)) - spheres.velocity(other(k)));
        this->spin_sum.set(k, spheres.spin(own(k)) + spheres.spin(other(k)));
        if constexpr (kRelative) this->relative_spin.set(k, spheres.spin(own(k)) - spheres.spin(other(k)));
      }
    });
  }

  /// Writes the pairs' histories to `next`, one after the other. Up to three numbers after the last are
  /// overwritten as well.
  template <bool kWide>
  void write_history(double* next) const {
    if constexpr (kWide && kHistoryInRecord)
      in_groups([&](std::size_t k, auto pairs) {
        Records numbers{};
        for (std::size_t n = 0; n < kHistory; ++n) numbers.from_lanes(n, this->history[n].value + k);
        numbers.transpose();
        for (std::size_t lane = 0; lane < pairs; ++lane)
          store(numbers.row[lane], next + (k + lane) * kHistory);
      });
    else
      for (std::size_t lane = 0; lane < count; ++lane)
        for (std::size_t n = 0; n < kHistory; ++n) next[lane * kHistory + n] = this->history[n][lane];
  }

  /// A reaction in the two halves of a ContactSum: force and rolling load, moment.
  struct Reaction {
    Four push, turn;
  };
  /// Calls add(pair, reaction on i, reaction on j) for every pair. The force on j is that on i, and so is its
  /// moment unless `kOtherDiffers`. `kTurns`: whether there are moments. Loads are multiplied by `rolling`.
  template <bool kTurns, bool kOtherDiffers, class Add>
  void for_reactions(double rolling, const Add& add) const {
    in_groups([&](std::size_t k, auto pairs) {
      Records pushes, turns{}, other_turns{};
      from_vectors(this->force, pushes, k);
      pushes.from_lanes(3, this->load.value + k);
      pushes.row[3] *= rolling;
      pushes.transpose();
      if constexpr (kTurns) {
        from_vectors(this->moment, turns, k);
        turns.transpose();
      }
      if constexpr (kOtherDiffers) {
        from_vectors(this->other_moment, other_turns, k);
        other_turns.transpose();
      }
      for (std::size_t lane = 0; lane < pairs; ++lane)
        add(pair[k + lane].pair, Reaction{pushes.row[lane], turns.row[lane]},
            Reaction{pushes.row[lane], kOtherDiffers ? other_turns.row[lane] : turns.row[lane]});
    });
  }

 private:
  using Vectors = typename Base::Vectors;

  /// Calls use(first lane, whether it stands for several) for all whole groups of lanes: a record's pairs at
  /// a time or one.
  template <bool kSeveral, class Use>
  void for_lanes(const Use& use) const {
    for (std::size_t k = 0; k < whole_groups(count); k += kSeveral ? Records::kCount : 1)
      use(k, std::bool_constant<kSeveral>{});
  }
  /// Calls use(first, how many) for the pairs of a record at a time; the compiler knows how many but for the
  /// last.
  template <class Use>
  void in_groups(const Use& use) const {
    std::size_t k = 0;
    for (; k + Records::kCount <= count; k += Records::kCount)
      use(k, std::integral_constant<std::size_t, Records::kCount>{});
    if (k < count) use(k, count - k);
  }

  static void to_vectors(Records& records, Vectors& lanes, std::size_t k) {
    records.transpose();
    records.to_lanes(0, &lanes.x[k]);
    records.to_lanes(1, &lanes.y[k]);
    records.to_lanes(2, &lanes.z[k]);
  }
  static void from_vectors(const Vectors& lanes, Records& records, std::size_t k) {
    records.from_lanes(0, lanes.x.value + k);
    records.from_lanes(1, lanes.y.value + k);
    records.from_lanes(2, lanes.z.value + k);
    records.row[3] = Four{};
  }
};

}  // namespace diefill::engine
