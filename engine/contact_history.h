// What touching pairs remember, taken out of the pair tables before a new search and put back into the new
// ones.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/pair_table.h"

namespace diefill::engine {

/// A touching pair outside any table: sphere `a` and its partner `b`, and a's spring against b (m). For grain
/// pairs both are spheres of grains (never images) with a < b; for walls b is the wall sphere's number over
/// all bodies.
struct RememberedContact {
  std::uint32_t a, b;
  Eigen::Vector3d spring;
};

/// Remembered contacts sorted by `a`, looked up by (a, b).
class ContactHistory {
 public:
  ContactHistory() = default;
  /// `spheres`: number of spheres that `a` counts over.
  ContactHistory(std::vector<RememberedContact> contacts, std::size_t spheres);

  /// The contact of a with b, or nullptr.
  const RememberedContact* find(std::uint32_t a, std::uint32_t b) const {
    if (first_.empty()) return nullptr;
    for (std::uint32_t k = first_[a]; k < first_[a + 1]; ++k)
      if (contacts_[k].b == b) return &contacts_[k];
    return nullptr;
  }

 private:
  std::vector<RememberedContact> contacts_;
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

/// Touching grain pairs of all blocks, renamed by `new_place`.
std::vector<RememberedContact> remember_grain_contacts(const std::vector<Block>& blocks,
                                                       const PairNaming& naming,
                                                       const std::vector<std::uint32_t>& new_place);
/// Touching wall pairs of all blocks, renamed by `new_place`.
std::vector<RememberedContact> remember_wall_contacts(const std::vector<Block>& blocks,
                                                      const PairNaming& naming,
                                                      const std::vector<std::uint32_t>& new_place);

}  // namespace diefill::engine
