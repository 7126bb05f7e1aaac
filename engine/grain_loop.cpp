#include <array>

#include "engine/contact_kernel.h"

namespace diefill::engine {

void BlockTally::start(std::size_t bodies) {
  viscous_work = tangential_work = drag_work = rolling_work = 0;
  overlap = {};
  touching = 0;
  body_force.assign(bodies, Eigen::Vector3d::Zero());
  body_torque.assign(bodies, Eigen::Vector3d::Zero());
}

namespace {

template <class Law, LeverArm kArm>
class GrainLoop final : public PairLoop {
 public:
  GrainLoop(const ContactParameters& parameters, double radius)
      : law_(parameters, effective_radius(radius, radius)) {}

  void add_forces(Block& block, const ContactScene& scene, BlockTally& tally) const override {
    const auto per_grain = static_cast<std::uint32_t>(scene.spheres.spheres_per_grain);
    for (std::uint32_t g = block.begin; g < block.end; ++g) {
      ContactSum own;
      for (std::uint32_t s = g * per_grain; s < (g + 1) * per_grain; ++s)
        add_sphere(block, s, s - block.begin * per_grain, scene.motion[g], own, scene, tally);
      ContactSum& sum = block.sums[g - block.begin];
      sum.force += own.force;
      sum.torque += own.torque;
      sum.rolling_load += own.rolling_load;
    }
  }

  double stored_energy(const Block& block, const ContactScene& scene) const override {
    const auto per_grain = static_cast<std::uint32_t>(scene.spheres.spheres_per_grain);
    const auto& table = block.grain_pairs;
    double energy = 0;
    for (std::uint32_t k = 0; k + 1 < table.first.size(); ++k)
      for (std::uint32_t p = table.first[k]; p < table.first[k + 1]; ++p) {
        const Eigen::Vector3d between = scene.spheres.position[block.begin * per_grain + k] -
                                        scene.spheres.position[table.partner[p].sphere];
        const double overlap = 2 * scene.sphere_radius - between.norm();
        if (overlap > 0) energy += law_.energy(overlap);
      }
    return energy;
  }

 private:
  /// All pairs of sphere `i`, number `k` of its block. Distances are tested first and touching pairs
  /// collected, so that the costly part runs without guessing.
  void add_sphere(Block& block, std::uint32_t i, std::uint32_t k, const GrainMotion& mover, ContactSum& own,
                  const ContactScene& scene, BlockTally& tally) const {
    auto& table = block.grain_pairs;
    const Eigen::Vector3d here = scene.spheres.position[i];
    const double reach_squared = 4 * scene.sphere_radius * scene.sphere_radius;
    std::array<std::uint32_t, 64> touching;
    std::uint32_t p = table.first[k];
    while (p < table.first[k + 1]) {
      std::size_t count = 0;
      for (; p < table.first[k + 1] && count < touching.size(); ++p) {
        const bool touches =
            (here - scene.spheres.position[table.partner[p].sphere]).squaredNorm() < reach_squared;
        touching[count] = p;
        count += touches;
        if (!touches) let_go(table, p);
      }
      for (std::size_t t = 0; t < count; ++t) add_pair(block, touching[t], here, mover, own, scene, tally);
    }
  }

  void add_pair(Block& block, std::uint32_t p, const Eigen::Vector3d& here, const GrainMotion& mover,
                ContactSum& own, const ContactScene& scene, BlockTally& tally) const {
    auto& table = block.grain_pairs;
    const GrainPartner partner = table.partner[p];
    const Eigen::Vector3d there = scene.spheres.position[partner.sphere];
    const GrainMotion& other = scene.motion[partner.grain];
    const double radius = scene.sphere_radius;
    const Eigen::Vector3d between = here - there;
    const double distance = between.norm();
    const Touch touch{between / distance, 2 * radius - distance};
    ContactSum& partners = block.sums[partner.slot];
    table.touching[p] = 1;
    tally.overlap.grains = std::max(tally.overlap.grains, touch.overlap);

    double load = 0;
    if constexpr (kArm == LeverArm::none) {
      const Eigen::Vector3d force = contact_force(law_, touch, mover.velocity - other.velocity,
                                                  scene.time_step, table.spring[p], tally, load);
      own.force += force;
      partners.force -= force;
    } else {
      const Eigen::Vector3d own_arm =
          lever_arm<kArm>(here - mover.position, -touch.normal, radius, touch.overlap);
      const Eigen::Vector3d arm =
          lever_arm<kArm>(there - other.position, touch.normal, radius, touch.overlap);
      const Eigen::Vector3d relative = mover.velocity + mover.angular_velocity.cross(own_arm) -
                                       other.velocity - other.angular_velocity.cross(arm);
      const Eigen::Vector3d force =
          contact_force(law_, touch, relative, scene.time_step, table.spring[p], tally, load);
      own.force += force;
      own.torque += own_arm.cross(force);
      partners.force -= force;
      partners.torque -= arm.cross(force);
    }
    if constexpr (kArm == LeverArm::surface) {
      own.rolling_load += law_.rolling_friction * load;
      partners.rolling_load += law_.rolling_friction * load;
    }
  }

  Law law_;
};

}  // namespace

std::unique_ptr<PairLoop> make_grain_loop(const ContactParameters& parameters, LeverArm arm,
                                          SpringLimit limit, double sphere_radius) {
  return with_law(parameters, arm, limit, [&]<class Law, class Arm>(std::type_identity<Law>, Arm) {
    return std::unique_ptr<PairLoop>(std::make_unique<GrainLoop<Law, Arm::value>>(parameters, sphere_radius));
  });
}

}  // namespace diefill::engine
