// Coulomb friction with a tangential spring on plain vectors (Bierwisch 2009, Eq. 2.7).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/spring_memory.h"

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
  };
  static constexpr int kMemory = 3;  ///< xi, m
  double coefficient;                ///< N/m^(3/2), kappa_t / sqrt(R_eff)
  double friction;                   ///< mu
  double cut_back;                   ///< 1 or 0; a number, as loops with a flag do not vectorise

  CundallFriction(const Parameters& given, const PairProperties& pair)
      : coefficient(given.tangential / std::sqrt(pair.effective_radius())),
        friction(given.friction),
        cut_back(given.cut_back ? 1.0 : 0.0) {}

  Vector3 force(double* memory, Vector3 normal, Vector3 sliding, double root_overlap, double load,
                double time_step) const {
    const Vector3 before = load_vector(memory);
    const Vector3 flat = in_plane(before, normal);
    const double kept = dot(flat, flat);
    const double regained = kept > 0 ? std::sqrt(dot(before, before) / kept) : 1;
    const Vector3 spring = regained * flat + time_step * sliding;
    const double stiffness = coefficient * root_overlap;
    const double slip = shortening(stiffness * length(spring), friction * load);
    store_vector(memory, (cut_back > 0 ? slip : 1.0) * spring);
    return (-stiffness * slip) * spring;
  }
};

static_assert(FrictionPart<CundallFriction>);

}  // namespace diefill::engine::laws
