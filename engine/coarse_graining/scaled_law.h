// A contact law of original grains between scaled ones: coarse graining by force scaling.
#pragma once

#include <cmath>

#include "engine/coarse_graining/force_scaling.h"
#include "engine/laws/composed_law.h"

namespace diefill::engine::coarse_graining {

/// Evaluates the contact in original variables by `Law` and multiplies forces by powers of l (Hu 2024, Eqs.
/// 3.32 to 3.45). The history holds original variables.
template <class Law>
class ScaledLaw {
 public:
  static constexpr int kHistory = Law::kHistory;

  /// `original`: the law between the small grains, made for scaling.original(pair).
  ScaledLaw(const ForceScaling& scaling, const Law& original)
      : law_(original),
        spin_(scaling.scale),
        overlap_(power(scaling, scaling.overlap_exponent)),
        gap_(power(scaling, scaling.gap_exponent)),
        stretch_(scaling.literal_spring ? 1 : power(scaling, scaling.spring_exponent)),
        turn_(scaling.literal_rolling ? 1 : scaling.scale),
        force_(power(scaling, scaling.force_exponent)),
        torque_(power(scaling, scaling.force_exponent + 1)),
        attraction_(power(scaling, scaling.attraction_exponent)) {}

  /// m, the largest gap of scaled grains at which the pair must still be considered.
  double range() const { return law_.range() * gap_; }

  /// As ComposedLaw::react, for scaled grains. The torque is such that it and force times the scaled lever
  /// arm share the factor ForceScaling::torque_factor, which the caller applies to their sum.
  laws::Reaction react(const laws::ContactState& state, double* history) const {
    return scaled(law_.react(original(state), history), state.normal);
  }
  /// The law between the small grains.
  const Law& parts() const { return law_; }
  /// The contact of small grains that represents the one at `state`.
  laws::ContactState original(const laws::ContactState& state) const {
    laws::ContactState original = state;
    original.overlap = original_overlap(state.overlap);
    original.spin = spin_ * state.spin;
    original.time_step = state.time_step / stretch_;
    original.rolling_step = state.rolling_step / turn_;
    return original;
  }
  /// The `reaction` of small grains as that of the scaled ones; `normal` from j to i.
  laws::Reaction scaled(laws::Reaction reaction, Vector3 normal) const {
    reaction.force = force_ * reaction.force + ((attraction_ - force_) * reaction.attraction) * normal;
    reaction.torque = torque_ * reaction.torque;
    reaction.load *= force_;
    reaction.viscous *= force_;
    reaction.normal_power *= force_;
    reaction.viscous_power *= force_;
    reaction.friction_power *= force_;
    reaction.rolling_power *= force_;
    reaction.attraction *= attraction_;
    reaction.attraction_power *= attraction_;
    return reaction;
  }

  /// J that the normal part holds: force times overlap, each scaled.
  double contact_energy(double overlap, const double* history) const {
    return force_ * overlap_ * law_.contact_energy(original_overlap(overlap), history);
  }
  /// J of the distant attraction.
  double attraction_energy(double overlap, const double* history) const {
    // In contact the attraction is constant and acts through the overlap as it is scaled.
    const double per_length = overlap > 0 ? overlap_ : gap_;
    return attraction_ * (gap_ * law_.attraction_energy(0, history) +
                          per_length * (law_.attraction_energy(original_overlap(overlap), history) -
                                        law_.attraction_energy(0, history)));
  }

  /// N/m, the steepest slope of the normal part's force at `overlap` (m) of the scaled grains, for a fresh
  /// contact.
  double stiffness(double overlap) const {
    const double history[kHistory + 1] = {};
    return force_ / overlap_ * law_.normal.stiffness(original_overlap(overlap), history);
  }
  /// N s/m, what the damping's force is over the speed at `overlap` (m).
  double damping(double overlap) const {
    const double original = original_overlap(overlap);
    return force_ * law_.damping.damping(original, std::sqrt(original));
  }

 private:
  static double power(const ForceScaling& scaling, double exponent) {
    return std::pow(scaling.scale, exponent);
  }
  double original_overlap(double overlap) const { return overlap > 0 ? overlap / overlap_ : overlap / gap_; }

  Law law_;
  double spin_, overlap_, gap_, stretch_, turn_;  // original over scaled, or scaled over original length
  double force_, torque_, attraction_;            // scaled over original
};

}  // namespace diefill::engine::coarse_graining
