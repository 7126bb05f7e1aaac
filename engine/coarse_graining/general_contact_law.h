// Any law of the sources, scaled by any rule of coarse graining, as the pair loop takes it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/coarse_graining/scaled_law.h"
#include "engine/laws/law_parameters.h"

namespace diefill::engine::laws {

/// A law composed at run time. Slower than ContactLaw, whose parts are fixed, unless the parts act on many
/// contacts at a time (react_by_parts()).
class GeneralContactLaw {
 public:
  static constexpr int kHistory = GeneralLaw::kHistory;
  static constexpr bool kRolls = true;
  /// Whether the parts are selected at run time, so that react_by_parts() serves it.
  static constexpr bool kByParts = true;
  /// m, arm of rolling friction against each grain's own spin; other rolling resistance is a part of the law.
  double rolling_friction = 0;

  /// `pair`: the grains as they are simulated. Throws what make_law throws.
  GeneralContactLaw(const LawParameters& parameters, const coarse_graining::ForceScaling& scaling,
                    const PairProperties& pair)
      : rolling_friction(scaling.scale * parameters.rolling.own_spin_arm()),
        law_(scaling, make_law(parameters, scaling.original(pair))),
        hysteretic_(law_.parts().normal.hysteretic() ? 1 : 0),
        form_(law_.parts().form()) {}

  /// m, largest gap at which the pair acts on each other.
  double range() const { return law_.range(); }

  /// As ComposedLaw::react.
  Reaction react(const ContactState& contact, double* history) const {
    return booked(law_.react(contact, history));
  }

  /// The law between the small grains: react() is original(), then what its parts make of that, summed up,
  /// then scaled().
  const GeneralLaw& parts() const { return law_.parts(); }
  /// Laws of one form and one scaling differ in their parts' numbers only.
  std::uint32_t form() const { return form_; }
  ContactState original(const ContactState& state) const { return law_.original(state); }
  Reaction scaled(const Reaction& reaction, Vector3 normal) const {
    return booked(law_.scaled(reaction, normal));
  }

  /// J that the normal force holds at `overlap` (m).
  double energy(double overlap, const double* history) const {
    return hysteretic_ > 0 ? 0 : law_.contact_energy(overlap, history);
  }

  /// N/m and N s/m, of the normal force of a fresh contact at `overlap` (m): what a time step must resolve.
  double stiffness(double overlap) const { return law_.stiffness(overlap); }
  double damping(double overlap) const { return law_.damping(overlap); }
  /// J of the distant attraction.
  double attraction_energy(double overlap, const double* history) const {
    return law_.attraction_energy(overlap, history);
  }

  /// Factors of the history's numbers when the pair is stored the other way round.
  static std::vector<double> history_signs() {
    return {GeneralLaw::kHistorySigns.begin(), GeneralLaw::kHistorySigns.end()};
  }
  /// As ComposedLaw::history_layout().
  std::vector<std::uint32_t> history_layout() const { return law_.parts().history_layout(); }

 private:
  /// Forces that hold no energy which could be got back count as viscous: the attraction, and a normal force
  /// with hysteresis.
  Reaction booked(Reaction reaction) const {
    reaction.viscous_power += reaction.attraction_power + hysteretic_ * reaction.normal_power;
    return reaction;
  }

  coarse_graining::ScaledLaw<GeneralLaw> law_;
  double hysteretic_;  // 1 or 0: a factor keeps the loop free of branches
  std::uint32_t form_;
};

}  // namespace diefill::engine::laws
