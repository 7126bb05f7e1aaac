// Capillary attraction of a liquid bridge (Rabinovich et al. 2005, Lambert et al. 2008; Hu 2024, Eqs. 2.42 to
// 2.44, 4.2).
#pragma once

#include <cmath>
#include <numbers>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// 4 pi R* gamma_L cos(theta) [1 - S / sqrt(S^2 + lambda / (pi R*))] at gap S, held at its value of S_min for
/// smaller gaps and in contact. A bridge forms when the spheres touch and lasts until the gap exceeds
/// (1 + theta / 2) lambda^(1/3); then there is none until they touch again. None on walls.
struct CapillaryBridge {
  struct Parameters {
    double surface_tension = 0;     ///< N/m, gamma_L
    double contact_angle = 0;       ///< rad, theta
    double liquid_fraction = 0.05;  ///< liquid over solid volume, a_1
    double bridge_share = 0.083;    ///< of the liquid of both spheres in one bridge, b_1
    double smallest_gap = 1e-6;     ///< m, S_min
    void check() const {
      require_range("surface tension", surface_tension, 0);
      require_range("contact angle", contact_angle, 0, std::numbers::pi / 2);
      require_range("liquid fraction", liquid_fraction, 0);
      require_range("bridge share", bridge_share, 0);
      require_positive("smallest gap S_min", smallest_gap);
    }
    Parameters similar(double l) const {
      return {l * surface_tension, contact_angle, liquid_fraction, bridge_share, l * smallest_gap};
    }
    bool surface_forces() const { return false; }
    bool attracts() const { return surface_tension > 0; }
  };
  static constexpr int kHistory = 1;  ///< 1 while there is a bridge
  static constexpr HistorySigns<1> kHistorySigns = {1};
  double strength = 0;  ///< N, 4 pi R* gamma_L cos(theta)
  double spread = 0;    ///< m^2, lambda / (pi R*)
  double rupture = 0;   ///< m
  double smallest = 0;  ///< m, S_min

  CapillaryBridge(const Parameters& given, const PairProperties& pair) : smallest(given.smallest_gap) {
    const double volume = bridge_volume(given, pair);
    if (volume <= 0) return;
    const double radius = pair.effective_radius();
    strength = 4 * std::numbers::pi * radius * given.surface_tension * std::cos(given.contact_angle);
    spread = volume / (std::numbers::pi * radius);
    rupture = (1 + 0.5 * given.contact_angle) * std::cbrt(volume);
  }

  /// lambda in m^3: a_1 b_1 times the volume of both spheres (Hu 2024, Eq. 4.2); none with a wall.
  static double bridge_volume(const Parameters& given, const PairProperties& pair) {
    if (pair.with_wall()) return 0;
    const double cubes =
        pair.radius_i * pair.radius_i * pair.radius_i + pair.radius_j * pair.radius_j * pair.radius_j;
    return given.liquid_fraction * given.bridge_share * 4.0 / 3.0 * std::numbers::pi * cubes;
  }

  double range() const { return rupture; }
  double force(double gap, double* history) const {
    const double holds = gap <= rupture ? history[0] : 0.0;
    const double bridge = gap <= 0 ? 1.0 : holds;
    history[0] = bridge;
    return -bridge * pull(gap > smallest ? gap : smallest);
  }
  /// J, zero at rupture (at S_min, should that be farther).
  double energy(double gap, const double* history) const {
    const double distance = gap > smallest ? gap : smallest;
    const double plateau = pull(distance) * (distance - gap);
    const double outermost = rupture > smallest ? rupture : smallest;
    return -history[0] * (strength * (slack(distance) - slack(outermost)) + plateau);
  }

 private:
  double pull(double gap) const {
    const double root = std::sqrt(gap * gap + spread);
    return strength * spread / (root * (gap + root));  // 1 - S / root without cancellation
  }
  /// sqrt(S^2 + spread) - S in m.
  double slack(double gap) const { return spread / (std::sqrt(gap * gap + spread) + gap); }
};

static_assert(AttractionPart<CapillaryBridge>);

}  // namespace diefill::engine::laws
