// Static and dynamic friction with a linear spring and dashpot (Luding 2008; Kottlan 2018, Eqs. 16 to 22,
// with the signs of Eq. 19 corrected).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_history.h"

namespace diefill::engine::laws {

/// Sticks with -k_t xi - gamma_t v until the spring exceeds mu_s times the load; then slides at mu_d times
/// the load without dashpot. The limit comes from the normal part, so any spring works: Luding's own gives
/// force + k_c h. As published the slip state is not stored and the force alternates between mu_d and mu_s
/// when they differ; `slip_memory` keeps mu_d until the sliding stops or reverses.
struct LudingFriction {
  struct Parameters {
    double stiffness = 60;        ///< N/m, k_t
    double damping = 0;           ///< kg/s, gamma_t
    double static_friction = 0;   ///< mu_s
    double dynamic_friction = 0;  ///< mu_d, at most mu_s
    bool slip_memory = false;
    void check() const {
      require_positive("tangential stiffness", stiffness);
      require_range("tangential damping", damping, 0);
      require_range("static friction coefficient", static_friction, 0);
      require_range("dynamic friction coefficient", dynamic_friction, 0, static_friction);
    }
    Parameters similar(double l) const {
      return {l * stiffness, l * l * damping, static_friction, dynamic_friction, slip_memory};
    }
    double largest_friction() const { return static_friction; }
    /// The dynamic coefficient keeps its share of the static one.
    bool set_friction(double coefficient) {
      dynamic_friction = static_friction > 0 ? dynamic_friction / static_friction * coefficient : coefficient;
      static_friction = coefficient;
      return true;
    }
  };
  static constexpr int kHistory = 4;  ///< xi in m; 1 while sliding with slip history
  static constexpr HistorySigns<4> kHistorySigns = {-1, -1, -1, 1};
  double stiffness, damping, static_friction, dynamic_friction;
  double slip_memory;  ///< 1 or 0; a number, as loops with a flag do not vectorise

  LudingFriction(const Parameters& given, const PairProperties&)
      : stiffness(given.stiffness),
        damping(given.damping),
        static_friction(given.static_friction),
        dynamic_friction(given.dynamic_friction),
        slip_memory(given.slip_memory ? 1.0 : 0.0) {}

  Vector3 force(double* history, Vector3 normal, Vector3 sliding, double, double load,
                double time_step) const {
    const Vector3 spring = in_plane(load_vector(history), normal) + time_step * sliding;
    const double onward = dot(spring, sliding);
    const double was_sliding = onward > 0 ? history[3] : 0.0;
    const double pull = stiffness * length(spring);
    const double threshold = (was_sliding > 0 ? dynamic_friction : static_friction) * load;
    const bool slides = pull > threshold;
    const double slip = slides ? dynamic_friction * load / pull : 1.0;
    store_vector(history, slip * spring);
    history[3] = slides ? slip_memory : 0.0;
    return (-stiffness * slip) * spring - (slides ? 0.0 : damping) * sliding;
  }
};

static_assert(FrictionPart<LudingFriction>);

}  // namespace diefill::engine::laws
