// Damping that grows with the radius of the contact area (Bierwisch 2009, Eq. 2.6).
#pragma once

#include "engine/laws/damping.h"
#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// f = -gamma_n sqrt(R_eff h) v.
struct BierwischDamping {
  struct Parameters {
    double damping = 0;  ///< Pa s, gamma_n
    void check() const { require_range("damping", damping, 0); }
    Parameters similar(double l) const { return {l * damping}; }
    bool dissipates() const { return damping > 0; }
  };
  HertzianDamping dashpot;

  BierwischDamping(const Parameters& given, const PairProperties& pair)
      : dashpot(given.damping, pair.effective_radius()) {}
  double force(double, double root_overlap, double separation_speed) const {
    return dashpot.force(root_overlap, separation_speed);
  }
  double damping(double, double root_overlap) const { return dashpot.at(root_overlap); }
};

static_assert(DampingPart<BierwischDamping>);

}  // namespace diefill::engine::laws
