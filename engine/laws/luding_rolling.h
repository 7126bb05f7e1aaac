// Rolling resistance by a linear spring and dashpot with a Coulomb-like limit (Luding 2008; Kottlan 2018,
// section on rolling).
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_history.h"

namespace diefill::engine::laws {

/// Spring k_r = f_r k_t R^2 per radian, dashpot 2 eta_r sqrt(I_r k_r) below the limit mu_roll load R. Refuses
/// inputs for which an explicit scheme is unstable, k_r dt^2 >= 4 I_r or c_r dt >= 2 I_r, with the reduced
/// moment of inertia I_r: the model owes its reputation of instability to them.
struct LudingRolling {
  struct Parameters {
    double rolling_friction = 0;       ///< mu_roll
    double tangential_stiffness = 60;  ///< N/m, k_t
    double stiffness_ratio = 1;        ///< f_r
    double damping_ratio = 0.3;        ///< eta_r, at most 0.3
    double time_step = 0;              ///< s, of the run, to refuse what it cannot resolve
    void check() const {
      require_range("rolling friction coefficient", rolling_friction, 0);
      require_positive("tangential stiffness", tangential_stiffness);
      require_positive("rolling stiffness ratio", stiffness_ratio);
      require_range("rolling damping ratio", damping_ratio, 0, 0.3);
      require_positive("time step of the rolling spring", time_step);
    }
    Parameters similar(double l) const {
      return {rolling_friction, l * tangential_stiffness, stiffness_ratio, damping_ratio, l * time_step};
    }
    double own_spin_arm() const { return 0; }
    void set_time_step(double seconds) { time_step = seconds; }
  };
  static constexpr int kHistory = 3;  ///< spring torque on j, N m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  static constexpr bool follows_time_step() { return false; }
  double stiffness;  ///< N m per radian, k_r
  double damping;    ///< N m s, c_r
  double arm;        ///< m, mu_roll R

  /// Throws std::invalid_argument for a pair the time step cannot resolve.
  LudingRolling(const Parameters& given, const PairProperties& pair)
      : stiffness(given.stiffness_ratio * given.tangential_stiffness * pair.effective_radius() *
                  pair.effective_radius()),
        damping(2 * given.damping_ratio * std::sqrt(pair.effective_inertia() * stiffness)),
        arm(given.rolling_friction * pair.effective_radius()) {
    const double inertia = pair.effective_inertia(), dt = given.time_step;
    if (stiffness * dt * dt >= 4 * inertia || damping * dt >= 2 * inertia) refuse(dt, inertia);
  }

  Vector3 torque(double* history, Vector3 normal, Vector3 relative_spin, double, StaticForce, double load,
                 double time_step) const {
    const Vector3 rolling = in_plane(relative_spin, normal);
    const Vector3 trial = in_plane(load_vector(history), normal) + (stiffness * time_step) * rolling;
    const double limit = arm * load, size = length(trial);
    const Vector3 spring = shortening(size, limit) * trial;
    store_vector(history, spring);
    return -spring - (size > limit ? 0 : damping) * rolling;
  }

 private:
  void refuse(double time_step, double inertia) const {
    std::ostringstream line;
    line << "Luding's rolling spring is unstable in time steps of " << time_step << " s; take steps below "
         << std::min(2 * std::sqrt(inertia / stiffness), 2 * inertia / damping)
         << " s or lower the rolling stiffness";
    throw std::invalid_argument(line.str());
  }
};

static_assert(RollingPart<LudingRolling>);

}  // namespace diefill::engine::laws
