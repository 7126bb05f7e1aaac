// Which law acts between which pair of grains: the same for all, or one for each pair of types. The pair loop
// is made for either, so that monodisperse powders look nothing up.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/contact/contact_batch.h"
#include "engine/powder/particle_types.h"
#include "engine/search/pair_table.h"

namespace diefill::engine {

/// Grains of one type.
template <class LawType>
class MonodispersePairs {
 public:
  using Law = LawType;
  static constexpr bool kMonodisperse = true;

  /// `radius`: m, of the spheres.
  MonodispersePairs(Law law, double radius) : law_(std::move(law)), reach_{2 * radius, radius} {}

  /// Number of a pair's law.
  static std::uint32_t classes(const Block&, GrainPair) { return 0; }
  LawOfPair<Law> of(std::uint32_t) const { return {law_, reach_}; }
  /// m^2, of the distance up to which the pair acts on each other.
  double reach_squared(std::uint32_t) const {
    const double reach = reach_.contact + law_.range();
    return reach * reach;
  }
  double range() const { return law_.range(); }
  bool rolls() const { return law_.rolling_friction != 0; }
  /// As PairLoop::history_layouts(), and the place of a pair's law among them.
  std::vector<HistoryLayout> history_layouts() const { return {law_.history_layout()}; }
  std::size_t law_number(const Block&, GrainPair) const { return 0; }

 private:
  Law law_;
  PairReach reach_;
};

/// Spheres of several classes, with any law between them.
class ClassPairs {
 public:
  using Law = laws::GeneralContactLaw;
  static constexpr bool kMonodisperse = false;

  /// Throws std::invalid_argument where a law makes no sense, or materials have none.
  ClassPairs(const ParticleTypes& types, const ContactLaws& contact);

  std::uint32_t classes(const Block& block, GrainPair pair) const {
    return block.sphere_class[pair.own] * count_ + block.sphere_class[pair.other];
  }
  LawOfPair<Law> of(std::uint32_t classes) const { return {laws_[law_[classes]], reach_[classes]}; }
  double reach_squared(std::uint32_t classes) const { return reach_squared_[classes]; }
  /// m, the largest of all laws.
  double range() const { return range_; }
  bool rolls() const {
    return std::any_of(laws_.begin(), laws_.end(), [](const Law& law) { return law.rolling_friction != 0; });
  }
  /// As in MonodispersePairs.
  std::vector<HistoryLayout> history_layouts() const {
    std::vector<HistoryLayout> layouts;
    for (const Law& law : laws_) layouts.push_back(law.history_layout());
    return layouts;
  }
  std::size_t law_number(const Block& block, GrainPair pair) const { return law_[classes(block, pair)]; }

 private:
  std::uint32_t count_;
  std::vector<Law> laws_;           ///< one for classes i and j in either order
  std::vector<std::uint32_t> law_;  ///< place in laws_ of classes i, j at i * count_ + j, as below
  std::vector<PairReach> reach_;
  std::vector<double> reach_squared_;
  double range_ = 0;
};

/// The surface of a wall, as the law of its contacts needs it.
struct WallSurface {
  std::string material = kWallMaterial;
  /// m, of wall spheres; infinite for planes and flat triangles.
  double radius = std::numeric_limits<double>::infinity();
  /// A plane of symmetry: grains meet their own mirror image, by the law of their own type.
  bool mirror = false;
};

/// The law between spheres of classes i and j. Throws std::invalid_argument where their materials have none,
/// or it makes no sense.
laws::GeneralContactLaw law_between(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i,
                                    ClassNumber j);
/// The law of spheres of `own` class at a wall. Throws for laws that attract from afar as well: wall spheres
/// overlap, and each would pull as if it stood alone.
laws::GeneralContactLaw law_at_wall(const ParticleTypes& types, const ContactLaws& contact, ClassNumber own,
                                    const WallSurface& wall);

}  // namespace diefill::engine
