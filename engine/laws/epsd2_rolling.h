// Rolling resistance by an elastic-plastic spring without dashpot, "EPSD2" (Hu 2024, Eqs. 2.47 to 2.50).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_history.h"

namespace diefill::engine::laws {

/// The torque builds up by 8 G* sqrt(R* h) R*^2 per radian of relative rolling and is cut at mu_r R* load. It
/// is kept, not the angle: a change of overlap does not rescale it.
struct Epsd2Rolling {
  struct Parameters {
    double rolling_friction = 0;  ///< mu_r
    double shear_modulus = 1e6;   ///< Pa, G*
    void check() const {
      require_range("rolling friction coefficient", rolling_friction, 0);
      require_positive("shear modulus G*", shear_modulus);
    }
    Parameters similar(double) const { return *this; }
    double own_spin_arm() const { return 0; }
    void set_time_step(double) {}
  };
  static constexpr int kHistory = 3;  ///< torque on i, N m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  static constexpr bool follows_time_step() { return false; }
  double coefficient;  ///< N m^(1/2) per radian, 8 G* R*^(5/2)
  double arm;          ///< m, mu_r R*

  Epsd2Rolling(const Parameters& given, const PairProperties& pair)
      : coefficient(8 * given.shear_modulus * std::sqrt(pair.effective_radius()) * pair.effective_radius() *
                    pair.effective_radius()),
        arm(given.rolling_friction * pair.effective_radius()) {}

  Vector3 torque(double* history, Vector3 normal, Vector3 relative_spin, double root_overlap, StaticForce,
                 double load, double time_step) const {
    const Vector3 trial = in_plane(load_vector(history), normal) -
                          (coefficient * root_overlap * time_step) * in_plane(relative_spin, normal);
    const Vector3 torque = shortening(length(trial), arm * load) * trial;
    store_vector(history, torque);
    return torque;
  }
};

static_assert(RollingPart<Epsd2Rolling>);

}  // namespace diefill::engine::laws
