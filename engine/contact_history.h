// What touching pairs remember, taken out of the pair tables before a new search and put back into the new
// ones.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/pair_table.h"

namespace diefill::engine {

/// Touching pairs outside any table, named by sphere `a` and its partner `b`. For grain pairs both are
/// spheres of grains (never images) with a < b; for walls b is the wall sphere's number over all bodies.
/// Pairs are sorted by `a` once all are added.
class ContactHistory {
 public:
  ContactHistory() = default;
  /// `width`: numbers that a pair remembers.
  explicit ContactHistory(std::size_t width) : width_(width) {}

  /// Adds what pair (a, b) remembers; `sign`: what each number is multiplied by, or nullptr.
  void add(std::uint32_t a, std::uint32_t b, const double* memory, const double* sign);
  /// Ends adding. `spheres`: number of spheres that `a` counts over.
  void sort(std::size_t spheres);

  /// What the contact of a with b remembers, or nullptr. A pair without memory is found, too.
  const double* find(std::uint32_t a, std::uint32_t b) const {
    if (first_.empty()) return nullptr;
    for (std::uint32_t k = first_[a]; k < first_[a + 1]; ++k)
      if (sorted_[k].b == b) return memory_.data() + sorted_[k].memory;
    return nullptr;
  }

 private:
  struct Entry {
    std::uint32_t a, b;
    std::size_t memory;
  };
  std::size_t width_ = 0;
  std::vector<Entry> added_, sorted_;
  std::vector<double> memory_ = {0.0};  ///< never empty, so that find() can point into it
  std::vector<std::uint32_t> first_;
};

/// Grains' new places after sorting: new_place[old grain], or kGone for those that left.
inline constexpr std::uint32_t kGone = 0xffffffff;

/// Where spheres and grains stand in the present tables, to translate pairs into lasting names.
struct PairNaming {
  std::size_t spheres_per_grain;
  std::size_t grains;  ///< real ones; images follow
  const std::vector<std::uint32_t>* image_owner;
  const std::vector<std::uint32_t>* body_first;  ///< first wall sphere number of each body

  /// The real sphere that `sphere` is or is an image of.
  std::uint32_t real_sphere(std::uint32_t sphere) const {
    const auto per_grain = static_cast<std::uint32_t>(spheres_per_grain);
    const std::uint32_t grain = sphere / per_grain;
    if (grain < grains) return sphere;
    return (*image_owner)[grain - grains] * per_grain + sphere % per_grain;
  }
};

/// Touching grain pairs of all blocks, renamed by `new_place`, sorted for `spheres` spheres. `sign`: what
/// each number that a pair remembers is multiplied by when the pair is seen from its other side.
ContactHistory remember_grain_contacts(const std::vector<Block>& blocks, const PairNaming& naming,
                                       const std::vector<std::uint32_t>& new_place,
                                       const std::vector<double>& sign, std::size_t spheres);
/// Touching wall pairs of all blocks, renamed by `new_place`, sorted for `spheres` spheres.
ContactHistory remember_wall_contacts(const std::vector<Block>& blocks, const PairNaming& naming,
                                      const std::vector<std::uint32_t>& new_place, std::size_t width,
                                      std::size_t spheres);

}  // namespace diefill::engine
