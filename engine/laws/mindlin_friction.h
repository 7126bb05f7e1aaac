// Mindlin's tangential spring without slip history, with a dashpot (Hu 2024, Eqs. 2.7, 2.13, 2.25).
#pragma once

#include <cmath>

#include "engine/laws/parameter_check.h"
#include "engine/laws/parts.h"
#include "engine/laws/restitution.h"
#include "engine/laws/spring_history.h"

namespace diefill::engine::laws {

/// What is compared with Coulomb's limit: spring and dashpot together (Hu 2024), or the spring alone, without
/// dashpot while sliding (LIGGGHTS).
enum class SlipTest { spring_and_dashpot, spring_alone };

/// Spring 8 G* sqrt(R* h) per metre, dashpot 4 sqrt(5/3) (-beta) sqrt(m* G*) (R* h)^(1/4).
struct MindlinFriction {
  struct Parameters {
    double shear_modulus = 1e6;  ///< Pa, G*
    double friction = 0;         ///< mu_s
    double restitution = 1;      ///< e of the dashpot, 0 to 1; 1: none
    SlipTest slip_test = SlipTest::spring_and_dashpot;
    void check() const {
      require_positive("shear modulus G*", shear_modulus);
      require_range("friction coefficient", friction, 0);
      require_range("coefficient of restitution", restitution, 0, 1);
    }
    Parameters similar(double) const { return *this; }
    double largest_friction() const { return friction; }
    bool set_friction(double coefficient) {
      friction = coefficient;
      return true;
    }
  };
  static constexpr int kHistory = 3;  ///< xi, m
  static constexpr HistorySigns<3> kHistorySigns = kVectorSigns;
  double spring_coefficient;   ///< N/m^(3/2)
  double dashpot_coefficient;  ///< kg/(s m^(1/4))
  double friction;             ///< mu_s
  double tested_share;         ///< of the dashpot in the slip test, 1 or 0

  MindlinFriction(const Parameters& given, const PairProperties& pair)
      : spring_coefficient(8 * given.shear_modulus * std::sqrt(pair.effective_radius())),
        dashpot_coefficient(
            4 * std::sqrt(5.0 / 3.0) * restitution_damping_ratio(given.restitution) *
            std::sqrt(pair.effective_mass() * given.shear_modulus * std::sqrt(pair.effective_radius()))),
        friction(given.friction),
        tested_share(given.slip_test == SlipTest::spring_and_dashpot ? 1.0 : 0.0) {}

  Vector3 force(double* history, Vector3 normal, Vector3 sliding, double root_overlap, double load,
                double time_step) const {
    const Vector3 spring = in_plane(load_vector(history), normal) + time_step * sliding;
    const double stiffness = spring_coefficient * root_overlap;
    const double damping = dashpot_coefficient * std::sqrt(root_overlap);
    const Vector3 tested = -stiffness * spring - (tested_share * damping) * sliding;
    const double size = length(tested), limit = friction * load;
    const bool slides = size > limit;
    const Vector3 slipping = shortening(size, limit) * tested;
    // While sliding, spring and dashpot together must give the force at the limit.
    const double compliance = stiffness > 0 ? 1 / stiffness : 0;
    const Vector3 slipped = -compliance * (slipping + (tested_share * damping) * sliding);
    store_vector(history, slides ? slipped : spring);
    return slides ? slipping : -stiffness * spring - damping * sliding;
  }
};

static_assert(FrictionPart<MindlinFriction>);

}  // namespace diefill::engine::laws
