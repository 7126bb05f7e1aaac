// The history of touching pairs, taken out of the pair tables before a new search and put back into the new
// tables.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/numerics/thread_pool.h"
#include "engine/search/pair_table.h"

namespace diefill::engine {

/// Touching pairs outside any table, named by sphere `a` and its partner `b`. For grain pairs both are
/// spheres of grains (never images) with a < b; for walls b is the wall sphere's number over all bodies.
/// Pairs are sorted by `a`: space for all is reserved first, then they are added.
class ContactHistory {
 public:
  ContactHistory() = default;
  /// `width`: numbers stored per pair; `spheres`: number of spheres that `a` counts over.
  ContactHistory(std::size_t width, std::size_t spheres) : width_(width), first_(spheres + 2, 0) {}

  /// Reserves space for one more pair of `a`.
  void reserve_pair(std::uint32_t a) { ++first_[a + 2]; }
  /// Ends reserving.
  void finish_reserving();
  /// Adds the history of pair (a, b); `sign`: factor of each number, or nullptr.
  void add(std::uint32_t a, std::uint32_t b, const double* history, const double* sign);

  /// The history of the contact of a with b, or nullptr. Pairs of width 0 are found, too.
  const double* find(std::uint32_t a, std::uint32_t b) const {
    if (first_.empty()) return nullptr;
    for (std::uint32_t k = first_[a]; k < first_[a + 1]; ++k)
      if (partner_[k] == b) return history_.data() + k * width_;
    return nullptr;
  }

 private:
  std::size_t width_ = 0;
  /// Pairs of `a` are [first_[a], first_[a + 1]); until all are added, first_[a + 1] is where the next one of
  /// `a` belongs.
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> partner_;
  std::vector<double> history_;
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

/// Touching grain pairs of all blocks, renamed by `new_place`, sorted for `spheres` spheres. `sign`: factor
/// of each number of the history when the pair is stored the other way round.
ContactHistory grain_contact_history(const std::vector<Block>& blocks, const PairNaming& naming,
                                     const std::vector<std::uint32_t>& new_place,
                                     const std::vector<double>& sign, std::size_t spheres, ThreadPool& pool);
/// Touching wall pairs of all blocks, renamed by `new_place`, sorted for `spheres` spheres.
ContactHistory wall_contact_history(const std::vector<Block>& blocks, const PairNaming& naming,
                                    const std::vector<std::uint32_t>& new_place, std::size_t width,
                                    std::size_t spheres, ThreadPool& pool);

}  // namespace diefill::engine
