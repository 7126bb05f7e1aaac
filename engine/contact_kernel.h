// What happens between two touching spheres: the contact law applied to their relative motion. Grain and wall
// loops both come here.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <type_traits>

#include "engine/laws/contact_law.h"
#include "engine/pair_loop.h"

namespace diefill::engine {

/// Two touching spheres: geometry of the contact.
struct Touch {
  Eigen::Vector3d normal;  ///< from j to i
  double overlap;          ///< m, h > 0
};

/// Arm (m) from a grain's centre to where contact forces act on it. `offset`: its sphere's centre seen from
/// the grain's centre; `outward`: unit vector from the sphere's centre to the contact.
template <LeverArm kArm>
Eigen::Vector3d lever_arm(const Eigen::Vector3d& offset, const Eigen::Vector3d& outward, double radius,
                          double overlap) {
  if constexpr (kArm == LeverArm::surface)
    return outward * radius;
  else if constexpr (kArm == LeverArm::center)
    return offset;
  else
    return offset + outward * (radius - 0.5 * overlap);
}

/// Force (N) on i by the law, given the velocity of i against j where they touch (m/s). Advances the spring
/// and books the work of damping and friction. `load` receives |f_e + f_v|.
template <class Law>
Eigen::Vector3d contact_force(const Law& law, const Touch& touch, const Eigen::Vector3d& relative_velocity,
                              double time_step, Eigen::Vector3d& spring, BlockTally& tally, double& load) {
  const double root_overlap = std::sqrt(touch.overlap);
  const double separation_speed = relative_velocity.dot(touch.normal);
  const auto normal = law.normal(touch.overlap, root_overlap, separation_speed);
  load = normal.load();
  Eigen::Vector3d force = normal.total() * touch.normal;
  tally.viscous_work += normal.viscous * separation_speed * time_step;
  if constexpr (Law::kHasSpring) {
    const Eigen::Vector3d sliding = relative_velocity - separation_speed * touch.normal;
    const Eigen::Vector3d tangential =
        law.friction.force(spring, touch.normal, sliding, root_overlap, load, time_step);
    tally.tangential_work += tangential.dot(sliding) * time_step;
    force += tangential;
  }
  ++tally.touching;
  return force;
}

/// Ends a contact's memory once the pair has come apart.
template <class Partner>
void let_go(PairTable<Partner>& table, std::uint32_t pair) {
  if (!table.touching[pair]) return;
  table.touching[pair] = 0;
  table.spring[pair].setZero();
}

/// Calls use(law, arm) with the types that the parameters ask for: `law` a ContactLaw type, `arm` a constant
/// of LeverArm. This is where a new cohesion or friction is registered: one line each.
template <class Use>
auto with_law(const ContactParameters& parameters, LeverArm arm, SpringLimit limit, const Use& use) {
  const auto with_arm = [&]<class Law>(std::type_identity<Law> law) {
    switch (arm) {
      case LeverArm::none:
        return use(law, std::integral_constant<LeverArm, LeverArm::none>{});
      case LeverArm::surface:
        return use(law, std::integral_constant<LeverArm, LeverArm::surface>{});
      case LeverArm::center:
        return use(law, std::integral_constant<LeverArm, LeverArm::center>{});
      default:
        return use(law, std::integral_constant<LeverArm, LeverArm::contact>{});
    }
  };
  const auto with_friction = [&]<class Cohesion>(std::type_identity<Cohesion>) {
    if (parameters.friction == 0)
      return with_arm(std::type_identity<laws::ContactLaw<Cohesion, laws::NoFriction>>{});
    if (limit == SpringLimit::cut_back)
      return with_arm(std::type_identity<laws::ContactLaw<Cohesion, laws::TangentialSpring<true>>>{});
    return with_arm(std::type_identity<laws::ContactLaw<Cohesion, laws::TangentialSpring<false>>>{});
  };
  if (parameters.work_of_adhesion == 0) return with_friction(std::type_identity<laws::NoCohesion>{});
  return with_friction(std::type_identity<laws::HertzianCohesion>{});
}

}  // namespace diefill::engine
