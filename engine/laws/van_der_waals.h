// Van der Waals attraction between spheres, with a smallest and a largest gap (Kottlan 2018, Eqs. 12 to 15).
#pragma once

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// -A r_eff / (6 D^2) at gap D between D_min and D_max; constant below D_min and in contact, zero beyond
/// D_max. Walls attract in contact only, with the force of D_min, unless `walls_at_distance`.
struct VanDerWaals {
  struct Parameters {
    double hamaker = 0;              ///< J, A_H
    double smallest_gap = 5e-9;      ///< m, D_min
    double largest_gap = 1e-6;       ///< m, D_max
    bool harmonic_mean = true;       ///< r_eff = 2 R_ij as published; false: Derjaguin's R_ij
    bool walls_at_distance = false;  ///< whether walls act without touching
    void check() const {
      require_range("Hamaker constant", hamaker, 0);
      require_positive("smallest gap D_min", smallest_gap);
      require_range("largest gap D_max", largest_gap, smallest_gap);
    }
    Parameters similar(double l) const {
      return {l * l * l * hamaker, l * smallest_gap, l * largest_gap, harmonic_mean, walls_at_distance};
    }
    bool surface_forces() const { return true; }
    bool attracts() const { return hamaker > 0; }
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  double coefficient;  ///< N m^2, A r_eff / 6
  double smallest;     ///< m
  double largest;      ///< m, 0 where it acts on touch only

  VanDerWaals(const Parameters& given, const PairProperties& pair)
      : coefficient(given.hamaker * pair.effective_radius() * (given.harmonic_mean ? 2 : 1) / 6),
        smallest(given.smallest_gap),
        largest(pair.with_wall() && !given.walls_at_distance ? 0 : given.largest_gap) {}

  double range() const { return largest; }
  double force(double gap, double*) const {
    const double distance = gap > smallest ? gap : smallest;
    return acts(gap) ? -coefficient / (distance * distance) : 0;
  }
  /// J, from the largest gap inwards; the step of the force at the cut-off holds no energy. Where it acts in
  /// contact only, zero at touch.
  double energy(double gap, const double*) const {
    const double distance = gap > smallest ? gap : smallest;
    const double outside = largest > 0 ? coefficient * (1 / distance - 1 / largest) : 0;
    const double plateau = (largest > 0 ? smallest : 0) - gap;  // way through the constant force
    const double inside = plateau > 0 ? coefficient * plateau / (smallest * smallest) : 0;
    return acts(gap) ? -outside - inside : 0;
  }

 private:
  bool acts(double gap) const { return largest > 0 ? gap <= largest : gap < 0; }
};

static_assert(AttractionPart<VanDerWaals>);

}  // namespace diefill::engine::laws
