// Luding's hysteretic spring: plastic loading, stiffer unloading, a cohesion branch (Luding 2008; Kottlan
// 2018, Eqs. 3 to 6, with the inverted fraction of Eq. 5 and the branch condition of Eq. 6 corrected).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Three branches: virgin loading k_1 h up to the plastic limit; unloading and reloading along a line of
/// slope k_2* between k_1 and k_2; the cohesion branch -k_c h, which reduces the stored deepest overlap.
/// Nothing is stored after the spheres separate. Limit: force + k_c h, zero on that branch (Kottlan 2018, Eq.
/// 18).
struct LudingNormal {
  struct Parameters {
    double loading = 100;            ///< N/m, k_1
    double unloading = 500;          ///< N/m, k_2, above k_1
    double cohesion = 0;             ///< N/m, k_c
    double plasticity_depth = 0.05;  ///< phi_f, plastic limit over the diameter-like length 2 R_ij
    void check() const {
      require_positive("loading stiffness k_1", loading);
      require(unloading > loading && std::isfinite(unloading),
              "unloading stiffness k_2 must exceed the loading stiffness k_1; use the linear spring for k_2 "
              "= k_1");
      require_range("cohesion stiffness k_c", cohesion, 0);
      require_positive("plasticity depth", plasticity_depth);
    }
    Parameters similar(double l) const {
      return {l * loading, l * unloading, l * cohesion, plasticity_depth};
    }
    bool attracts() const { return cohesion > 0; }
    /// Kottlan 2018 has van der Waals attraction beside the cohesion branch.
    bool includes_surface_forces() const { return false; }
    bool damping_in_load() const { return true; }
    double hertzian_modulus() const { return 0; }
    double linear_stiffness() const { return loading; }
    bool set_work_of_adhesion(double w) const { return w == 0; }
  };
  static constexpr int kHistory = 1;  ///< deepest overlap so far, m
  static constexpr HistorySigns<1> kHistorySigns = {1};
  static constexpr bool hysteretic() { return true; }
  double k1, k2, kc;     ///< N/m
  double plastic_limit;  ///< m, overlap beyond which unloading is as stiff as k_2 (Kottlan 2018, Eq. 4)

  LudingNormal(const Parameters& given, const PairProperties& pair)
      : k1(given.loading),
        k2(given.unloading),
        kc(given.cohesion),
        plastic_limit(k2 / (k2 - k1) * given.plasticity_depth * 2 * pair.effective_radius()) {}

  StaticForce force(double overlap, double, double* history) const {
    const double deepest = overlap > history[0] ? overlap : history[0];
    const double slope = unloading_slope(deepest);
    const double line = unloading_force(overlap, deepest, slope);
    const bool virgin = deepest < plastic_limit && line >= k1 * overlap;
    const bool cohesive = !virgin && line <= -kc * overlap;
    const double force = virgin ? k1 * overlap : (cohesive ? -kc * overlap : line);
    history[0] = cohesive ? (slope + kc) / (slope - k1) * overlap : deepest;
    return {force, force + kc * overlap};
  }

  /// Area in J between the un- and reloading line and zero force, from the present overlap to where the line
  /// crosses zero: f^2 / (2 k_2*). It is what unloading gives back down to that point, or, on the cohesion
  /// side, what the attraction gives back up to it. The rest of the work done was lost to plasticity.
  double energy(double overlap, const double* history) const {
    const double deepest = overlap > history[0] ? overlap : history[0];
    const double slope = unloading_slope(deepest);
    const double line = unloading_force(overlap, deepest, slope);
    return overlap > 0 ? 0.5 * line * line / slope : 0;
  }
  /// k_2, the steepest line a contact can come to.
  double stiffness(double, const double*) const { return k2; }

  /// k_2* in N/m after the deepest overlap in m (Kottlan 2018, Eq. 5, fraction corrected).
  double unloading_slope(double deepest) const {
    return deepest < plastic_limit ? k1 + (k2 - k1) * deepest / plastic_limit : k2;
  }

 private:
  double unloading_force(double overlap, double deepest, double slope) const {
    const double turning = deepest < plastic_limit ? deepest : plastic_limit;
    return slope * (overlap - turning) + k1 * turning;
  }
};

static_assert(NormalPart<LudingNormal>);

}  // namespace diefill::engine::laws
