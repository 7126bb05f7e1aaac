// What grain and wall loops have in common: batches of touching pairs with their contact history, and the
// choice of the law that a scene uses.
#pragma once

#include <type_traits>

#include "engine/contact/contact_batch.h"
#include "engine/contact/pair_laws.h"
#include "engine/contact/pair_loop.h"
#include "engine/laws/bierwisch_law.h"
#include "engine/laws/contact_law.h"

namespace diefill::engine {

/// Reads a pair's contact history into `lane` of the batch; that of a new contact is zero.
template <class Law>
void load_history(const double* history, ContactBatch<Law>& batch, std::size_t lane) {
  for (std::size_t k = 0; k < ContactBatch<Law>::kHistory; ++k) batch.history[k][lane] = history[k];
}

/// Writes it back.
template <class Law>
void store_history(const ContactBatch<Law>& batch, std::size_t lane, double* history) {
  for (std::size_t k = 0; k < ContactBatch<Law>::kHistory; ++k) history[k] = batch.history[k][lane];
}

/// Notes whether pair `p` touches now; a new contact begins with zero history.
template <class Pair>
void note_touching(PairTable<Pair>& table, std::size_t p, bool touches) {
  // The processor cannot predict whether a near pair touches, but it can predict that few contacts are new.
  const unsigned begins = static_cast<unsigned>(touches) & (1U - table.touching[p]);
  if (begins != 0) std::fill_n(table.history_of(p), table.width, 0.0);
  table.touching[p] = touches;
}

/// The pairs from `begin` to `end` that touched when distances were last tested.
template <class Pair>
std::vector<std::uint32_t> touching_pairs(const PairTable<Pair>& table, std::size_t begin, std::size_t end) {
  std::vector<std::uint32_t> touching;
  for (std::size_t p = begin; p < end; ++p)
    if (table.touching[p]) touching.push_back(static_cast<std::uint32_t>(p));
  return touching;
}

/// Sums over the lanes of all batches of a block.
template <class Law>
class BatchTally {
 public:
  /// Takes in the overlaps over the smaller sphere's radius, `smaller_radius(lane)` in m, where radii differ.
  template <class SmallerRadius>
  void add_over_radius(const ContactBatch<Law>& batch, const SmallerRadius& smaller_radius) {
    for (std::size_t lane = 0; lane < batch.count; ++lane)
      deepest_over_radius_ = std::max(deepest_over_radius_, batch.overlap[lane] / smaller_radius(lane));
  }
  void add(const ContactBatch<Law>& batch) {
    viscous_power_.add(batch.viscous_power, batch.count);
    friction_power_.add(batch.friction_power, batch.count);
    if constexpr (Law::kRolls) rolling_power_.add(batch.rolling_power, batch.count);
    deepest_.add(batch.overlap, batch.count);
    for (std::size_t lane = 0; lane < batch.count; ++lane) touching_ += batch.overlap[lane] > 0;
  }
  double deepest() const { return deepest_.max(); }
  double deepest_over_radius() const { return deepest_over_radius_; }
  /// Adds the pairs and their work in one step of `time_step` (s).
  void add_to(BlockTally& tally, double time_step) const {
    tally.viscous_work += viscous_power_.total() * time_step;
    tally.tangential_work += friction_power_.total() * time_step;
    tally.rolling_work += rolling_power_.total() * time_step;
    tally.touching += touching_;
  }

 private:
  LaneSum viscous_power_, friction_power_, rolling_power_;
  LaneMax deepest_;
  double deepest_over_radius_ = 0;
  std::uint64_t touching_ = 0;
};

/// Calls use(arm, clumped) with constants of LeverArm and of whether grains are clumped; only for arms that
/// such grains can have, so that no loops are made that nobody runs.
template <class Use>
auto with_arm(LeverArm arm, bool clumps, const Use& use) {
  constexpr std::true_type kClumps;
  constexpr std::false_type kSingle;
  if (!clumps && arm == LeverArm::none)
    return use(std::integral_constant<LeverArm, LeverArm::none>{}, kSingle);
  if (!clumps) return use(std::integral_constant<LeverArm, LeverArm::surface>{}, kSingle);
  if (arm == LeverArm::none) return use(std::integral_constant<LeverArm, LeverArm::none>{}, kClumps);
  if (arm == LeverArm::center) return use(std::integral_constant<LeverArm, LeverArm::center>{}, kClumps);
  return use(std::integral_constant<LeverArm, LeverArm::contact>{}, kClumps);
}

/// Bierwisch's law, where spheres are of one class, forces are not scaled and that is their law with
/// `material`: the tuned loops know it beforehand. Throws what ContactLaws::between() throws.
std::optional<laws::BierwischLaw> tuned_law(const ParticleTypes& types, const ContactLaws& contact,
                                            const std::string& material);

/// Calls use(law, arm, clumped) with the types that the parameters ask for: `law` a ContactLaw type, `arm`
/// and `clumped` as with_arm() gives them. This is where a cohesion or friction that deserves a loop of its
/// own is registered: one line each.
template <class Use>
auto with_law(const ContactParameters& parameters, LeverArm arm, bool clumps, SpringLimit limit,
              const Use& use) {
  const auto of = [&]<class Law>(std::type_identity<Law> law) {
    return with_arm(arm, clumps, [&](auto constant, auto clumped) { return use(law, constant, clumped); });
  };
  const auto with_friction = [&]<class Cohesion>(std::type_identity<Cohesion>) {
    if (parameters.friction == 0)
      return of(std::type_identity<laws::ContactLaw<Cohesion, laws::NoFriction>>{});
    if (limit == SpringLimit::cut_back)
      return of(std::type_identity<laws::ContactLaw<Cohesion, laws::TangentialSpring<true>>>{});
    return of(std::type_identity<laws::ContactLaw<Cohesion, laws::TangentialSpring<false>>>{});
  };
  if (parameters.work_of_adhesion == 0) return with_friction(std::type_identity<laws::NoCohesion>{});
  return with_friction(std::type_identity<laws::HertzianCohesion>{});
}

}  // namespace diefill::engine
