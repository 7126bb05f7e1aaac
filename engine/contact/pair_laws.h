// Which law acts between which pair of grains: the same for all, or one for each pair of kinds. The pair loop
// is made for either, so that powders whose grains are all alike look nothing up.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/contact/contact_batch.h"
#include "engine/powder/particle_types.h"
#include "engine/search/pair_table.h"

namespace diefill::engine {

/// Grains of one kind.
template <class LawType>
class MonodispersePairs {
 public:
  using Law = LawType;
  static constexpr bool kAlike = true;

  /// `radius`: m, of the spheres.
  MonodispersePairs(Law law, double radius) : law_(std::move(law)), reach_{2 * radius, radius} {}

  /// Number of a pair's law.
  static std::uint32_t kinds(const Block&, GrainPair) { return 0; }
  LawOfPair<Law> of(std::uint32_t) const { return {law_, reach_}; }
  /// m^2, of the distance up to which the pair acts on each other.
  double reach_squared(std::uint32_t) const {
    const double reach = reach_.contact + law_.range();
    return reach * reach;
  }
  double range() const { return law_.range(); }
  double rolling_friction() const { return law_.rolling_friction; }

 private:
  Law law_;
  PairReach reach_;
};

/// Grains of several kinds, with any law of the sources between them.
class KindPairs {
 public:
  using Law = laws::GeneralContactLaw;
  static constexpr bool kAlike = false;

  /// Throws std::invalid_argument where a law makes no sense, or materials have none.
  KindPairs(const KindTable& kinds, const GrainMix& mix);

  std::uint32_t kinds(const Block& block, GrainPair pair) const {
    return block.kind[pair.own] * count_ + block.kind[pair.other];
  }
  LawOfPair<Law> of(std::uint32_t kinds) const { return {laws_[law_[kinds]], reach_[kinds]}; }
  double reach_squared(std::uint32_t kinds) const { return reach_squared_[kinds]; }
  /// m, the largest of all laws.
  double range() const { return range_; }
  static double rolling_friction() { return Law::rolling_friction; }

 private:
  std::uint32_t count_;
  std::vector<Law> laws_;           ///< one for kinds i and j in either order
  std::vector<std::uint32_t> law_;  ///< place in laws_ of kinds i, j at i * count_ + j, as below
  std::vector<PairReach> reach_;
  std::vector<double> reach_squared_;
  double range_ = 0;
};

/// The law between a grain of `kind` and another, or a wall: throws as KindPairs does.
laws::GeneralContactLaw law_of_kinds(const KindTable& kinds, const GrainMix& mix, KindNumber i, KindNumber j);
/// `wall_radius`: m, of wall spheres; infinite for planes. Throws for laws that attract from afar as well.
laws::GeneralContactLaw law_with_wall(const KindTable& kinds, const GrainMix& mix, KindNumber kind,
                                      const std::string& wall_material, double wall_radius);

}  // namespace diefill::engine
