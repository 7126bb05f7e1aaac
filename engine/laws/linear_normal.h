// A linear spring: the elastic limit of Luding's hysteretic spring, and what walls of that model use.
#pragma once

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// f = k h.
struct LinearNormal {
  struct Parameters {
    double stiffness = 100;  ///< N/m, k
    void check() const { require_positive("normal stiffness", stiffness); }
    Parameters similar(double l) const { return {l * stiffness}; }
    bool attracts() const { return false; }
    bool includes_surface_forces() const { return false; }
    bool damping_in_load() const { return true; }
    double hertzian_modulus() const { return 0; }
    double linear_stiffness() const { return stiffness; }
    bool set_work_of_adhesion(double w) const { return w == 0; }
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool hysteretic() { return false; }
  double spring = 0;  ///< N/m

  LinearNormal(const Parameters& given, const PairProperties&) : spring(given.stiffness) {}

  StaticForce force(double overlap, double, double*) const { return {spring * overlap, spring * overlap}; }
  double energy(double overlap, const double*) const { return 0.5 * spring * overlap * overlap; }
  double stiffness(double, const double*) const { return spring; }
};

static_assert(NormalPart<LinearNormal>);

}  // namespace diefill::engine::laws
