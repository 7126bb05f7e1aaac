#include "engine/contact_kernel.h"

namespace diefill::engine {

namespace {

template <class Law, LeverArm kArm>
class WallLoop final : public PairLoop {
 public:
  WallLoop(const ContactParameters& parameters, double radius, const std::vector<double>& wall_radii) {
    for (const double wall_radius : wall_radii)
      laws_.emplace_back(parameters, effective_radius(radius, wall_radius));
  }

  void add_forces(Block& block, const ContactScene& scene, BlockTally& tally) const override {
    visit(block, scene,
          [&](std::uint32_t i, std::uint32_t p, const WallPartner& partner, double distance_squared,
              double reach, const Eigen::Vector3d& between_in_body) {
            if (distance_squared < reach * reach)
              add_pair(block, i, p, partner, std::sqrt(distance_squared), reach, between_in_body, scene,
                       tally);
            else
              let_go(block.wall_pairs, p);
          });
  }

  double stored_energy(const Block& block, const ContactScene& scene) const override {
    double energy = 0;
    visit(block, scene,
          [&](std::uint32_t, std::uint32_t, const WallPartner& partner, double distance_squared, double reach,
              const Eigen::Vector3d&) {
            const double overlap = reach - std::sqrt(distance_squared);
            if (overlap > 0) energy += laws_[partner.body].energy(overlap);
          });
    return energy;
  }

 private:
  /// Calls action(sphere, pair, partner, squared distance, sum of radii, vector from wall to grain sphere in
  /// the body's frame). Distances are taken in the body's frame: a sphere is carried there once, instead of
  /// all wall spheres here.
  template <class Action>
  void visit(const Block& block, const ContactScene& scene, const Action& action) const {
    const auto per_grain = static_cast<std::uint32_t>(scene.spheres.spheres_per_grain);
    const auto& table = block.wall_pairs;
    for (std::uint32_t k = 0; k + 1 < table.first.size(); ++k) {
      const std::uint32_t i = block.begin * per_grain + k;
      std::uint32_t body = kGone;
      Eigen::Vector3d in_body = Eigen::Vector3d::Zero();
      double reach = 0;
      for (std::uint32_t p = table.first[k]; p < table.first[k + 1]; ++p) {
        const WallPartner partner = table.partner[p];
        if (partner.body != body) {
          body = partner.body;
          const BodyMotion& pose = scene.body_motion[body];
          in_body = pose.rotation.transpose() * (scene.spheres.position[i] - pose.translation);
          reach = scene.sphere_radius + scene.bodies[body].sphere_radius();
        }
        const Eigen::Vector3d between = in_body - scene.bodies[body].centres()[partner.sphere];
        action(i, p, partner, between.squaredNorm(), reach, between);
      }
    }
  }

  void add_pair(Block& block, std::uint32_t i, std::uint32_t p, const WallPartner& partner, double distance,
                double reach, const Eigen::Vector3d& between_in_body, const ContactScene& scene,
                BlockTally& tally) const {
    auto& table = block.wall_pairs;
    const auto per_grain = static_cast<std::uint32_t>(scene.spheres.spheres_per_grain);
    const BodyMotion& body = scene.body_motion[partner.body];
    const GrainMotion& mover = scene.motion[i / per_grain];
    const Eigen::Vector3d here = scene.spheres.position[i];
    const Touch touch{body.rotation * between_in_body / distance, reach - distance};
    const double radius = scene.sphere_radius;
    const Eigen::Vector3d contact_point = here - touch.normal * (radius - 0.5 * touch.overlap);
    const Eigen::Vector3d wall_velocity = body.velocity_at(contact_point);
    ContactSum& sum = block.sums[i / per_grain - block.begin];
    table.touching[p] = 1;
    tally.overlap.walls = std::max(tally.overlap.walls, touch.overlap);

    double load = 0;
    Eigen::Vector3d force;
    if constexpr (kArm == LeverArm::none) {
      force = contact_force(laws_[partner.body], touch, mover.velocity - wall_velocity, scene.time_step,
                            table.spring[p], tally, load);
    } else {
      const Eigen::Vector3d arm =
          lever_arm<kArm>(here - mover.position, -touch.normal, radius, touch.overlap);
      force = contact_force(laws_[partner.body], touch,
                            mover.velocity + mover.angular_velocity.cross(arm) - wall_velocity,
                            scene.time_step, table.spring[p], tally, load);
      sum.torque += arm.cross(force);
    }
    if constexpr (kArm == LeverArm::surface) sum.rolling_load += laws_[partner.body].rolling_friction * load;
    sum.force += force;
    tally.body_force[partner.body] -= force;
    tally.body_torque[partner.body] -= (contact_point - body.translation).cross(force);
  }

  std::vector<Law> laws_;  ///< one a body: R_eff differs with the radius of its spheres (OP-5)
};

}  // namespace

std::unique_ptr<PairLoop> make_wall_loop(const ContactParameters& parameters, LeverArm arm, SpringLimit limit,
                                         double sphere_radius, const std::vector<double>& wall_radii) {
  return with_law(parameters, arm, limit, [&]<class Law, class Arm>(std::type_identity<Law>, Arm) {
    return std::unique_ptr<PairLoop>(
        std::make_unique<WallLoop<Law, Arm::value>>(parameters, sphere_radius, wall_radii));
  });
}

}  // namespace diefill::engine
