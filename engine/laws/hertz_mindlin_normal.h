// Hertz' spring in the form that goes with Mindlin's tangential spring (Hu 2024, Eqs. 2.12, 2.18).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// f = 4/3 E* sqrt(R*) h^(3/2), 1/E* = sum of (1 - nu^2) / E (Hu 2024, Eqs. 2.14, 2.19).
struct HertzMindlinNormal {
  struct Parameters {
    double modulus = 1e7;  ///< Pa, E*
    void check() const { require_positive("modulus E*", modulus); }
    Parameters similar(double) const { return *this; }
    bool attracts() const { return false; }
    bool includes_surface_forces() const { return false; }
    bool damping_in_load() const { return true; }
    double hertzian_modulus() const { return modulus; }
    double linear_stiffness() const { return 0; }
    bool set_work_of_adhesion(double w) const { return w == 0; }
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool hysteretic() { return false; }
  double coefficient = 0;  ///< N/m^(3/2)

  HertzMindlinNormal(const Parameters& given, const PairProperties& pair)
      : coefficient(4.0 / 3.0 * given.modulus * std::sqrt(pair.effective_radius())) {}

  StaticForce force(double overlap, double root_overlap, double*) const {
    const double hertz = coefficient * overlap * root_overlap;
    return {hertz, hertz};
  }
  double energy(double overlap, const double*) const {
    return 0.4 * coefficient * overlap * overlap * std::sqrt(overlap);
  }
  double stiffness(double overlap, const double*) const { return 1.5 * coefficient * std::sqrt(overlap); }
};

static_assert(NormalPart<HertzMindlinNormal>);

/// E* in Pa of two surfaces of Young's moduli in Pa and Poisson's ratios (Hu 2024, Eq. 2.14).
inline double contact_modulus(double young_i, double poisson_i, double young_j, double poisson_j) {
  return 1 / ((1 - poisson_i * poisson_i) / young_i + (1 - poisson_j * poisson_j) / young_j);
}
/// G* in Pa of two surfaces (Hu 2024, Eq. 2.26).
inline double contact_shear_modulus(double young_i, double poisson_i, double young_j, double poisson_j) {
  return 1 /
         (2 * (2 - poisson_i) * (1 + poisson_i) / young_i + 2 * (2 - poisson_j) * (1 + poisson_j) / young_j);
}

}  // namespace diefill::engine::laws
