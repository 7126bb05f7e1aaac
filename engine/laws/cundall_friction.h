// Coulomb friction with a tangential spring (Bierwisch 2009, Eq. 2.7); whether sliding cuts the spring back
// is selected at run time.
#pragma once

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_history.h"
#include "engine/laws/tangential_spring.h"

namespace diefill::engine::laws {

/// f = -min[kappa_t sqrt(h / R_eff) |xi|, mu load] xi / |xi|. The spring xi turns with the contact plane and
/// keeps its length; `cut_back` shortens it while sliding so that it never holds more than the limit.
struct CundallFriction {
  struct Parameters {
    double tangential = 0;  ///< N/m, kappa_t
    double friction = 0;    ///< mu
    bool cut_back = true;   ///< whether the spring slips with the contact
    void check() const {
      require_range("tangential stiffness", tangential, 0);
      require_range("friction coefficient", friction, 0);
    }
    Parameters similar(double l) const { return {l * tangential, friction, cut_back}; }
    double largest_friction() const { return friction; }
    bool set_friction(double coefficient) {
      friction = coefficient;
      return true;
    }
  };
  static constexpr int kHistory = 3;  ///< xi, m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  TangentialSpring<true> spring;
  double cut_back;  ///< 1 or 0; a number, as loops with a flag do not vectorise

  CundallFriction(const Parameters& given, const PairProperties& pair)
      : spring(given.tangential, given.friction, pair.effective_radius()),
        cut_back(given.cut_back ? 1.0 : 0.0) {}

  Vector3 force(double* history, Vector3 normal, Vector3 sliding, double root_overlap, double load,
                double time_step) const {
    spring.turn(history, normal);
    spring.stretch(history, sliding, time_step);
    const Vector3 stretched = load_vector(history);
    const Vector3 force = spring.limited(history, root_overlap, load);
    const Vector3 slipped = load_vector(history);
    store_vector(history, cut_back > 0 ? slipped : stretched);
    return force;
  }
};

static_assert(FrictionPart<CundallFriction>);

}  // namespace diefill::engine::laws
