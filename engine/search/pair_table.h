// Near pairs of one block of grains with their contact history, in the order in which the pair loop reads
// them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/numerics/vector3.h"
#include "engine/search/contact_sums.h"
#include "engine/search/distance_rounding.h"

namespace diefill::engine {

/// Number of a sphere in its block: first the block's own spheres, then their partners from elsewhere. Short,
/// because lists of pairs are what a step reads most of.
using LocalSphere = std::uint16_t;

/// A near pair between grains.
struct GrainPair {
  LocalSphere own, other;
};

/// A near pair with a wall: the grain's sphere, and the number of the wall's sphere (or plane) in its body.
struct WallPair {
  std::uint32_t wall;
  LocalSphere own;
};
inline std::uint32_t part_of(const WallPair& pair) {
  return pair.wall;
}

/// The near pairs of one sphere with one body, wall spheres nearest first. A pair cannot touch before the
/// sphere has moved, in the body's frame, by what parted the two when the list was made: as a rule all but a
/// few of a run need no look.
struct WallRun {
  Vector3 place;        ///< m, of the sphere's centre in the body's frame when the list was made
  std::uint32_t first;  ///< pair
  LocalSphere own;

  /// m: with the sphere at `now` (m, body frame), pairs that were as far apart as this (Block::wall_distance)
  /// are still no nearer than `limit` (m).
  double within(Vector3 now, double limit) const { return kDistanceRounding * (limit + length(now - place)); }
};

/// Room for `count` values in `values`, which becomes empty. Memory that would stand idle is given back: a
/// step's speed is that of the memory it has to pass through.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t count) {
  if (values.capacity() > count + count / 4) std::vector<Value>().swap(values);
  values.clear();
  values.reserve(count);
}

/// The meaning of each number of a pair's history by one law: equal numbers, equal meaning.
using HistoryLayout = std::vector<std::uint32_t>;

/// Sets to 0 those numbers of `history` that do not mean the same in both layouts, which are of one length.
inline void clear_changed(double* history, const HistoryLayout& before, const HistoryLayout& next) {
  for (std::size_t k = 0; k < before.size(); ++k)
    if (before[k] != next[k]) history[k] = 0;
}

/// Pairs with a history of `width` numbers each; that of a pair that does not touch has no meaning.
template <class Pair>
struct PairTable {
  std::size_t width = 0;
  std::vector<Pair> pair;
  std::vector<std::uint8_t> touching;  ///< 1 while the pair is within the law's reach
  std::vector<double> history;         ///< SI units, as the law lays them out

  std::size_t size() const { return pair.size(); }
  /// Empties the table and makes room for `count` pairs with a history of `numbers` each.
  void start(std::size_t count, std::size_t numbers) {
    width = numbers;
    make_room(pair, count);
    make_room(touching, count);
    make_room(history, count * width);
  }
  /// `stored`: history of a touching pair, or nullptr; `sign`: what each number is multiplied by, or nullptr.
  void add(const Pair& added, const double* stored, const double* sign) {
    pair.push_back(added);
    touching.push_back(stored != nullptr);
    for (std::size_t k = 0; k < width; ++k)
      history.push_back(!stored ? 0.0 : sign ? sign[k] * stored[k] : stored[k]);
  }
  double* history_of(std::size_t p) { return history.data() + p * width; }
  const double* history_of(std::size_t p) const { return history.data() + p * width; }
  /// Calls visit(p, history) for every touching pair p in their order.
  template <class Visit>
  void visit_touching(const Visit& visit) const {
    for (std::size_t p = 0; p < size(); ++p)
      if (touching[p]) visit(p, history_of(p));
  }
  /// Makes p, which did not touch, a touching pair with the history `stored`.
  void restore(std::size_t p, const double* stored) {
    touching[p] = 1;
    std::copy_n(stored, width, history_of(p));
  }
};

/// Near pairs between grains. Half of them do not touch even in a dense bed, so only those that do have a
/// history: a first one that is 0, then theirs in the order of the table.
struct GrainPairTable {
  /// Place of the history of a contact that has just begun.
  static constexpr std::uint32_t kNothing = 0;
  /// Numbers after the last one that may be read, so that loads of four need not mind the end.
  static constexpr std::size_t kSpare = 3;

  std::size_t width = 0;  ///< numbers in the history of a touching pair
  std::vector<GrainPair> pair;
  std::vector<std::uint8_t> touching;  ///< 1 while the pair is within the law's reach
  std::vector<double> history;         ///< SI units, as the law lays them out, and kSpare numbers

  std::size_t size() const { return pair.size(); }
  /// Empties the table and makes room for `count` pairs with a history of `numbers` each.
  void start(std::size_t count, std::size_t numbers) {
    width = numbers;
    make_room(pair, count);
    make_room(touching, count);
    history.assign(width, 0.0);
  }
  /// As PairTable::add().
  void add(const GrainPair& added, const double* stored, const double* sign) {
    pair.push_back(added);
    touching.push_back(stored != nullptr);
    if (!stored) return;
    for (std::size_t k = 0; k < width; ++k) history.push_back(sign ? sign[k] * stored[k] : stored[k]);
  }
  /// Ends adding.
  void finish() {
    history.insert(history.end(), kSpare, 0.0);
    history.shrink_to_fit();
  }
  /// Room in `next` for kNothing's history, whose numbers are set, and then those of the `count` pairs that
  /// touch after a step.
  void make_room_for_history(std::vector<double>& next, std::size_t count) const {
    const std::size_t needed = (count + 1) * width + kSpare;
    // Contacts come and go, and buffers go from block to block: fresh memory costs more than some that is
    // idle.
    if (next.capacity() < needed || next.capacity() > 2 * needed) make_room(next, needed + needed / 8);
    next.resize(needed);
    std::fill_n(next.begin(), width, 0.0);
  }
  /// Takes over the histories in `next`, for which room was made; `next` becomes the former memory: it has
  /// just been read, so that what another block writes to it next is written to the cache.
  void keep_history(std::vector<double>& next) { history.swap(next); }
  /// History number `place`: counted from 1 among those of touching pairs, or kNothing.
  const double* history_at(std::uint32_t place) const { return history.data() + place * width; }
  /// Prefetches `count` histories from `place` on, as far as there are so many.
  /// Always inlined: prefetch.h gives the reason.
  [[gnu::always_inline]] void fetch_history(std::size_t place, std::size_t count) const {
    constexpr std::size_t kCacheLine = 64 / sizeof(double);
    const std::size_t end = std::min((place + count) * width, history.size());
    for (std::size_t at = place * width; at < end; at += kCacheLine) __builtin_prefetch(&history[at]);
  }
  /// Calls visit(p, history) for every touching pair p in their order.
  template <class Visit>
  void visit_touching(const Visit& visit) const {
    std::uint32_t place = kNothing;
    for (std::size_t p = 0; p < size(); ++p)
      if (touching[p]) visit(p, history_at(++place));
  }
  /// Calls change(p, history) for every touching pair p in their order; it may change the numbers.
  template <class Change>
  void change_touching(const Change& change) {
    visit_touching(
        [&](std::size_t p, const double* read) { change(p, history.data() + (read - history.data())); });
  }
  /// As PairTable::restore(), for pairs in their order, in a table in which none touched.
  void restore(std::size_t p, const double* stored) {
    touching[p] = 1;
    history.insert(history.end() - kSpare, stored, stored + width);
  }
};

/// A run of grains that one thread works on at a time: its pairs, and the forces they cause. Sums 0 to
/// grains() - 1 belong to the block's own grains, the rest to `foreign` ones.
struct Block {
  std::uint32_t begin = 0, end = 0;  ///< grains
  std::uint32_t spheres_per_grain = 1;
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();  ///< m, point that moments of clumped grains are about
  GrainPairTable grain_pairs;
  PairTable<WallPair> wall_pairs;             ///< body after body, sphere after sphere
  std::vector<std::uint32_t> wall_first;      ///< first wall pair of each body, and the number of all
  std::vector<WallRun> wall_runs;             ///< body after body; one more stands for the end
  std::vector<std::uint32_t> wall_run_first;  ///< first run of each body, and the number of all
  std::vector<float> wall_distance;     ///< m, of a wall pair's centres when the list was made, rounded down;
                                        ///< 0 where it is not known (planes)
  std::vector<std::uint32_t> partners;  ///< spheres outside the block (of grains or images), rising
  std::vector<std::uint16_t> slot;      ///< sum that forces on a local sphere of a clumped grain are added to
  std::vector<std::uint16_t> sphere_class;  ///< of a local sphere; empty where there is one class
  std::vector<std::uint32_t> foreign;       ///< grains outside the block that its pairs push
  std::vector<std::uint32_t> seen;  ///< where they are clumped: each itself, or its image that pairs meet
  /// Of the block's pairs in the last step; at its end those of own grains have become all that acts on them
  /// but weight and air at rest, unless grains sleep.
  ContactSums sums;

  std::uint32_t grains() const { return end - begin; }
  std::uint32_t own_spheres() const { return grains() * spheres_per_grain; }
  /// Sum that forces on a local sphere are added to: single spheres have one each.
  template <bool kClumps>
  std::size_t slot_of(LocalSphere local) const {
    return kClumps ? slot[local] : local;
  }
  /// Number of a local sphere among all spheres.
  std::uint32_t sphere(LocalSphere local) const {
    return local < own_spheres() ? begin * spheres_per_grain + local : partners[local - own_spheres()];
  }
};

}  // namespace diefill::engine
