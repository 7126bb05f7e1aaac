// The Edinburgh elasto-plastic adhesion law, "EEPA": plastic loading, stiffer unloading and reloading, and an
// adhesive branch that is deeper the more the contact was flattened (Morrissey 2013; Thakur et al., Granular
// Matter 16, 2014, 383).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Exponent n of the overlap in the force: 1 or 3/2.
enum class EdinburghBranch { hertzian, linear };

/// With u = h^n, and u_p = (1 - k_1/k_2) h_max^n of the plastic overlap h_p after the deepest one h_max:
///   f = -f_0 + k_1 u            first loading,
///   f = -f_0 + k_2 (u - u_p)    un- and reloading,
///   f = -f_0 - k_adh u          adhesive branch, where that is more. It shortens the history so that
///                               reloading leaves it along k_2, and is left at h = 0 with the force f_0.
/// This branch begins at the smallest force -f_min, f_min = 3/2 pi Delta gamma a with a^2 = 2 h_p R_eff -
/// h_p^2: k_adh = (f_min - f_0) / u_min with u_min = u_p - (f_min - f_0) / k_2. It keeps its k_adh until
/// first loading goes on. Forms taken here: k_adh is at most k_2, which f_min exceeds for small h_p, and 0
/// where f_min is below f_0; the adhesive exponent is n, too. Limit of friction: |f + f_0 + k_adh u|, zero on
/// the adhesive branch.
struct EdinburghNormal {
  struct Parameters {
    EdinburghBranch branch = EdinburghBranch::hertzian;
    double modulus = 5e6;           ///< Pa, E* of k_1 = 4/3 E* sqrt(R_eff), Hertzian branch
    double stiffness = 100;         ///< N/m, k_1 of the linear branch
    double plasticity_ratio = 0.5;  ///< 1 - k_1/k_2, 0 (elastic) to below 1
    double pull_off = 0;            ///< N, f_0
    double surface_energy = 0;      ///< J/m^2, Delta gamma of the pair of surfaces
    bool is_hertzian() const { return branch == EdinburghBranch::hertzian; }
    bool is_linear() const { return !is_hertzian(); }
    void check() const {
      require_positive(is_hertzian() ? "modulus E*" : "loading stiffness k_1",
                       is_hertzian() ? modulus : stiffness);
      require_range("plasticity ratio 1 - k_1/k_2", plasticity_ratio, 0, 0.99);
      require_range("pull-off force", pull_off, 0);
      require_range("surface energy", surface_energy, 0);
    }
    Parameters similar(double l) const {
      return {branch, modulus, l * stiffness, plasticity_ratio, l * l * pull_off, l * surface_energy};
    }
    bool attracts() const { return pull_off > 0 || surface_energy > 0; }
    bool includes_surface_forces() const { return attracts(); }
    bool damping_in_load() const { return true; }
    double hertzian_modulus() const { return is_hertzian() ? modulus : 0; }
    double linear_stiffness() const { return is_linear() ? stiffness : 0; }
    bool set_work_of_adhesion(double w) {
      surface_energy = w;
      return true;
    }
  };
  static constexpr int kHistory = 2;  ///< u_p in m^n; k_adh in N/m^n
  static constexpr HistorySigns<2> kHistorySigns = {1, 1};
  static constexpr bool hysteretic() { return true; }
  std::uint32_t history_unit() const { return root_share > 0 ? 1 : 0; }
  double unloading;      ///< N/m^n, k_2
  double plastic_share;  ///< u_p over h_max^n
  double plastic_depth;  ///< h_p over h_max
  double root_share;     ///< 1 for n = 3/2, 0 for n = 1; a number, as loops with a flag do not vectorise
  double pull_off;       ///< N, f_0
  double adhesion;       ///< N/m, 3/2 pi Delta gamma
  double diameter;       ///< m, 2 R_eff

  EdinburghNormal(const Parameters& given, const PairProperties& pair)
      : unloading((given.is_hertzian() ? 4.0 / 3.0 * given.modulus * std::sqrt(pair.effective_radius())
                                       : given.stiffness) /
                  (1 - given.plasticity_ratio)),
        plastic_share(given.plasticity_ratio),
        plastic_depth(given.is_hertzian() ? std::cbrt(given.plasticity_ratio * given.plasticity_ratio)
                                          : given.plasticity_ratio),
        root_share(given.is_hertzian() ? 1.0 : 0.0),
        pull_off(given.pull_off),
        adhesion(1.5 * std::numbers::pi * given.surface_energy),
        diameter(2 * pair.effective_radius()) {}

  StaticForce force(double overlap, double root_overlap, double* history) const {
    const double power = overlap * (root_share * root_overlap + (1 - root_share));
    // First loading is where the line k_2 begins: the lines meet there.
    const bool first = plastic_share * power >= history[0];
    const double plastic = first ? plastic_share * power : history[0];
    const double k_adh = first ? adhesive_slope(overlap, plastic) : history[1];
    const double line = unloading * (power - plastic);
    const bool on_line = line >= -k_adh * power;
    const double elastic = on_line ? line : -k_adh * power;
    history[0] = on_line ? plastic : (1 + k_adh / unloading) * power;
    history[1] = k_adh;
    return {elastic - pull_off, elastic + k_adh * power};
  }

  /// Area in J between the un- and reloading line and -f_0, from the present overlap to h_p, and the work of
  /// f_0: what unloading gives back, or, on the adhesive side, what the attraction gives back up to h_p.
  double energy(double overlap, const double* history) const {
    const double power = overlap * (root_share > 0 ? std::sqrt(overlap) : 1);
    const double plastic = std::max(plastic_share * power, history[0]);
    const double depth = root_share > 0 ? std::cbrt(plastic * plastic) : plastic;
    const double order = 2 + 0.5 * root_share;  // n + 1
    const double area = (overlap * power - depth * plastic) / order - plastic * (overlap - depth);
    return unloading * area - pull_off * overlap;
  }
  /// n k_2 h^(n - 1), the slope of the un- and reloading line, which a contact can come to at any overlap.
  double stiffness(double overlap, const double*) const {
    return unloading * (root_share > 0 ? 1.5 * std::sqrt(overlap) : 1);
  }

 private:
  /// k_adh in N/m^n of a contact at its deepest `overlap` (m), of which `plastic` (m^n) will stay.
  double adhesive_slope(double overlap, double plastic) const {
    const double depth = plastic_depth * overlap;
    const double squared = depth < diameter ? depth * (diameter - depth) : 0;
    const double wanted = adhesion * std::sqrt(squared) - pull_off;
    const double most = 0.5 * unloading * plastic;  // where k_adh = k_2
    const double below = wanted < most ? wanted : most;
    const double pull = below > 0 ? below : 0;
    const double rest = unloading * plastic - pull;
    return rest > 0 ? unloading * pull / rest : 0;
  }
};

static_assert(NormalPart<EdinburghNormal>);

}  // namespace diefill::engine::laws
