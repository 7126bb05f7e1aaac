// Adhesive elastic contact after Johnson, Kendall and Roberts, simplified: made and lost at zero overlap
// (Hu 2024, section 2.2; Parteli et al. 2014).
#pragma once

#include <cmath>
#include <numbers>

#include "engine/laws/jkr_contact_radius.h"
#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Which form of the normal load limits friction and rolling: |F + 2 F_po| (Thornton), or Hu 2024, Eq. 2.28
/// as printed, where a factor 4 is missing from the second term.
enum class JkrLoad { corrected, printed };

/// F = 4 E* a^3 / (3 R*) - 4 sqrt(pi gamma E* a^3) with the contact radius a (Hu 2024,
/// Eqs. 2.12, 2.23, 2.46). F jumps to -8/9 F_po at zero overlap, F_po = 3 pi gamma R* (Eq. 2.29).
struct JkrNormal {
  struct Parameters {
    double modulus = 1e7;               ///< Pa, E*
    double surface_energy = 0;          ///< J/m^2 of one surface, gamma; work of adhesion is twice that
    JkrLoad load = JkrLoad::corrected;  ///< limit of friction and rolling
    void check() const {
      require_positive("modulus E*", modulus);
      require_range("surface energy", surface_energy, 0);
    }
    Parameters similar(double l) const { return {modulus, l * surface_energy, load}; }
    bool attracts() const { return surface_energy > 0; }
    bool includes_surface_forces() const { return true; }
    bool damping_in_load() const { return false; }  ///< Hu 2024
    double hertzian_modulus() const { return modulus; }
    double linear_stiffness() const { return 0; }
    bool set_work_of_adhesion(double w) {
      surface_energy = 0.5 * w;
      return true;
    }
  };
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool hysteretic() { return false; }
  double radius;            ///< m, R*
  double modulus;           ///< Pa, E*
  double neck;              ///< m^(1/2), sqrt(4 pi gamma / E*)
  double adhesive_start;    ///< m^(1/2), where Newton's method starts
  double pull_off;          ///< N, F_po
  double attraction_share;  ///< of the attraction in the limit: 1 corrected, 1/4 printed

  JkrNormal(const Parameters& given, const PairProperties& pair)
      : radius(pair.effective_radius()),
        modulus(given.modulus),
        neck(std::sqrt(4 * std::numbers::pi * given.surface_energy / given.modulus)),
        adhesive_start(std::cbrt(2 * neck * radius)),
        pull_off(3 * std::numbers::pi * given.surface_energy * radius),
        attraction_share(given.load == JkrLoad::corrected ? 1.0 : 0.25) {}

  /// m, at overlap h >= 0 in m.
  double contact_radius(double overlap) const {
    return jkr_contact_radius_newton(radius * overlap, neck * radius, adhesive_start);
  }

  StaticForce force(double overlap, double, double*) const {
    const double a = contact_radius(overlap);
    const double repulsion = 4.0 / 3.0 * modulus / radius * a * a * a;
    const double attraction = 2 * modulus * neck * a * std::sqrt(a);
    return {repulsion - attraction, std::abs(repulsion - attraction_share * attraction + 2 * pull_off)};
  }

  /// Integral of the force from zero overlap, in J; closed form by substituting the contact radius.
  double energy(double overlap, const double*) const {
    return primitive(contact_radius(overlap)) - primitive(contact_radius(0));
  }

  double stiffness(double overlap, const double*) const {
    const double a = contact_radius(overlap), root = std::sqrt(a);
    const double rise = 4 * modulus / radius * a * a * root - 3 * modulus * neck * a;
    const double run = 2 * a * root / radius - 0.5 * neck;  // both times sqrt(a), which may be zero
    return run > 0 ? rise / run : 0;
  }

 private:
  double primitive(double a) const {
    const double a2 = a * a;
    return modulus * (8.0 / 15.0 / (radius * radius) * a2 * a2 * a -
                      4.0 / 3.0 * neck / radius * a2 * a * std::sqrt(a) + 0.5 * neck * neck * a2);
  }
};

static_assert(NormalPart<JkrNormal>);

}  // namespace diefill::engine::laws
