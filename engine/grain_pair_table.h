// Near pairs between the grains of one block, with what touching ones remember. Most steps need to look only
// at those that are about to touch: the close ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/room.h"

namespace diefill::engine {

/// Number of a sphere in its block: first the block's own spheres, then their partners from elsewhere. Short,
/// because lists of pairs are what a step reads most of.
using LocalSphere = std::uint16_t;

/// A near pair between grains.
struct GrainPair {
  LocalSphere own, other;
};

/// Pairs of one block, close ones among the near, touching ones among the close. Only those that touch have a
/// memory: one after the other in the order of the table, behind a first one that is 0.
class GrainPairTable {
 public:
  /// Place of what a contact remembers that has just begun.
  static constexpr std::uint32_t kNothing = 0;
  /// Pairs whose bits make a word.
  static constexpr std::size_t kWord = 64;

  std::vector<GrainPair> pair;  ///< near pairs

  std::size_t size() const { return pair.size(); }
  /// Numbers that a touching pair remembers.
  std::size_t remembers() const { return width_; }
  /// Empties the table and makes room for `count` pairs that remember `numbers` each.
  void start(std::size_t count, std::size_t numbers);
  /// `remembered`: numbers of a touching pair, or nullptr; `sign`: what each is multiplied by, or nullptr.
  /// The touching ones are all that is close, until list_close() is called.
  void add(const GrainPair& added, const double* remembered, const double* sign);
  /// Ends adding.
  void finish();
  /// Makes p, which did not touch, a touching pair that remembers `remembered`; for pairs in their order, in
  /// a table in which none touched and adding has ended.
  void recall(std::size_t p, const double* remembered);

  /// Notes that pairs have come nearer by up to `approach` (m) in this step. Returns whether others than the
  /// close ones might touch now: these must then be listed anew.
  bool age(double approach) {
    margin_ -= approach;
    return !(margin_ > 0);
  }
  /// Makes those near pairs the close ones whose bits in `near`, a word for 64 of them, are set, and those
  /// that touched in the last step: all that touch now, or could before pairs have come nearer by `margin`
  /// (m). What else is close changes no bit of any result.
  void list_close(const std::vector<std::uint64_t>& near, double margin);
  /// Close pairs in the order of the table.
  const std::vector<GrainPair>& close() const { return close_; }
  /// Which of the 64 close pairs from 64 `w` on touched in the last step, one bit each.
  std::uint64_t touching(std::size_t w) const { return touching_[w]; }
  void set_touching(std::size_t w, std::uint64_t bits) { touching_[w] = bits; }

  /// Room for what `count` touching pairs remember after a step, one after the other behind kNothing's, whose
  /// numbers are set.
  void make_room_to_remember(std::vector<double>& remembered, std::size_t count) const;
  /// Takes over what touching pairs remember, for which room was made; `remembered` becomes what they did
  /// before: it has just been read, so that what another block writes to it next is written to the cache.
  void keep(std::vector<double>& remembered) { memory_.swap(remembered); }
  /// Memory number `place`: counted from 1 among those of touching pairs, or kNothing. Three numbers behind
  /// it may be read as well.
  const double* memory_at(std::uint32_t place) const { return memory_.data() + place * width_; }
  /// Asks for `count` memories from `place` on, which are going to be read soon, as far as there are so many.
  void fetch_memory(std::size_t place, std::size_t count) const {
    constexpr std::size_t kCacheLine = 64 / sizeof(double);
    const std::size_t end = std::min((place + count) * width_, memory_.size());
    for (std::size_t at = place * width_; at < end; at += kCacheLine) __builtin_prefetch(&memory_[at]);
  }

  /// Calls visit(p, memory) for every touching pair p in their order.
  template <class Visit>
  void visit_touching(const Visit& visit) const {
    visit_near([&](std::size_t p, std::uint32_t place) {
      if (place != kNothing) visit(p, memory_at(place));
    });
  }
  /// Calls visit(p, place) for every near pair p, with the place of its memory.
  template <class Visit>
  void visit_near(const Visit& visit) const {
    std::size_t k = 0;
    std::uint32_t touched = kNothing;
    for (std::size_t p = 0; p < size(); ++p) {
      bool touches = false;
      if (bit(is_close_, p)) touches = bit(touching_, k++);
      visit(p, touches ? ++touched : kNothing);
    }
  }

 private:
  /// Numbers behind the last one that may be read, so that loads of four need not mind the end.
  static constexpr std::size_t kSpare = 3;

  static bool bit(const std::vector<std::uint64_t>& words, std::size_t k) {
    return (words[k / kWord] >> k % kWord & 1U) != 0;
  }
  void add_touching(std::size_t p);

  std::size_t width_ = 0;
  std::vector<std::uint64_t> is_close_;  ///< a bit a near pair
  std::vector<GrainPair> close_;
  std::vector<std::uint64_t> touching_;  ///< a bit a close pair: whether it is within the law's reach
  std::vector<double> memory_;           ///< SI units, as the law lays them out, and kSpare numbers
  double margin_ = 0;  ///< m, by how much pairs may come nearer before one that is not close may touch
};

}  // namespace diefill::engine
