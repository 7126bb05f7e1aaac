#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

#include "engine/contact_kernel.h"
#include "engine/mesh_contacts.h"

namespace diefill::engine {

namespace {

/// Pairs of grains with walls. `kComposed`: several spheres a grain, moments about the block's reference
/// point.
template <class Law, LeverArm kArm, bool kComposed>
class WallLoop final : public PairLoop {
 public:
  /// `laws`: one a body; `radius`: m, of the grains' spheres.
  WallLoop(std::vector<Law> laws, double radius) : radius_(radius), laws_(std::move(laws)) {}

  void add_forces(Block& block, const ContactScene& scene, BlockTally& tally) const override {
    if (block.wall_pairs.size() == 0) return;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      if (block.wall_first[body] < block.wall_first[body + 1]) add_body(block, body, scene, tally);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    Batch& batch = batch_of_thread<Batch>();
    batch.count = 1;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
      const PairReach distances{reach(scene, body), radius_};
      for (const std::uint32_t p :
           touching_pairs(block.wall_pairs, block.wall_first[body], block.wall_first[body + 1])) {
        const WallPair pair = block.wall_pairs.pair[p];
        const WallTouch touch{p, separation_in_body(pair, body, scene)};
        pack(block, body, touch, scene, 0, batch);
        batch.fill_last_group();
        react<kArm, kComposed>(batch, laws_[body], distances, 0);
        const Vector3 separation = batch.separation[0];
        visit({pair.own, pair.own, batch.force[0],
               scene.spheres.position(pair.own) - contact_share(touch, body, scene) * separation});
      }
    }
  }

  double stored_energy(const Block& block, const ContactScene& scene) const override {
    double energy = 0;
    std::vector<WallTouch> touches;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
      if (scene.bodies[body].meshed()) {
        touches.clear();
        find_mesh_touches(block.wall_pairs, mesh_pairs(block, body, scene), touches);
        for (const auto& touch : touches)
          energy += laws_[body].energy(reach(scene, body) - length(touch.separation),
                                       block.wall_pairs.memory_of(touch.pair));
        continue;
      }
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        const double overlap =
            reach(scene, body) - length(separation_in_body(block.wall_pairs.pair[p], body, scene));
        if (overlap > 0) energy += laws_[body].energy(overlap, block.wall_pairs.memory_of(p));
      }
    }
    return energy;
  }

  std::vector<double> memory_signs() const override { return Law::memory_signs(); }
  double range() const override { return 0; }

 private:
  using Batch = ContactBatch<Law>;

  double reach(const ContactScene& scene, std::size_t body) const {
    return radius_ + scene.bodies[body].sphere_radius();
  }

  MeshPairs mesh_pairs(const Block& block, std::size_t body, const ContactScene& scene) const {
    return {block.wall_first[body], block.wall_first[body + 1],
            scene.bodies[body],     scene.body_motion[body],
            scene.spheres,          radius_};
  }

  /// Centre of the grain's sphere (m) seen from the wall's, in the body's frame. From a plane or triangle,
  /// its nearest point stands for the wall sphere.
  static Vector3 separation_in_body(const WallPair& pair, std::size_t body, const ContactScene& scene) {
    const BodyMotion& pose = scene.body_motion[body];
    const Eigen::Vector3d place =
        pose.rotation.transpose() * (eigen(scene.spheres.position(pair.own)) - pose.translation);
    const WallBody& wall = scene.bodies[body];
    if (wall.meshed()) return plain(separation_from_triangle(wall, pair.wall, place, scene.sphere_radius));
    if (!wall.flat()) return plain(place - wall.centres()[pair.wall]);
    const WallPlane& plane = wall.planes()[pair.wall];
    // A centre on the plane still has a side to be pushed to.
    const double height = std::max(plane.normal.dot(place - plane.point), 1e-9 * scene.sphere_radius);
    return plain(height * plane.normal);
  }

  void find_touching(Block& block, std::size_t body, const ContactScene& scene,
                     std::vector<WallTouch>& touching, BlockTally& tally) const {
    touching.clear();
    if (scene.bodies[body].meshed()) {
      const MeshPairs near = mesh_pairs(block, body, scene);
      tally.overlap.walls =
          std::max(tally.overlap.walls, find_mesh_touches(block.wall_pairs, near, touching));
      return note_mesh_touches(block.wall_pairs, near, touching);
    }
    const double reach_squared = reach(scene, body) * reach(scene, body);
    for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
      const Vector3 between = separation_in_body(block.wall_pairs.pair[p], body, scene);
      const bool touches = dot(between, between) < reach_squared;
      note_touching(block.wall_pairs, p, touches);
      if (touches) touching.push_back({p, between});
    }
  }

  void add_body(Block& block, std::size_t body, const ContactScene& scene, BlockTally& tally) const {
    thread_local std::vector<WallTouch> touching;
    find_touching(block, body, scene, touching, tally);
    Batch& batch = batch_of_thread<Batch>();
    BatchTally<Law> batches;
    const PairReach distances{reach(scene, body), radius_};
    for (std::size_t done = 0; done < touching.size(); done += batch.count) {
      batch.count = std::min(touching.size() - done, Batch::kLanes);
      const WallTouch* pairs = touching.data() + done;
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        pack(block, body, pairs[lane], scene, lane, batch);
      batch.fill_last_group();
      with_instructions(scene.instructions,
                        [&] { react<kArm, kComposed>(batch, laws_[body], distances, scene.time_step); });
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        hand_out(batch, lane, block, body, pairs[lane], scene, tally);
      batches.add(batch);
    }
    batches.book(scene.time_step, tally, tally.overlap.walls);
  }

  /// Way from the grain sphere's centre to the middle of the overlap, over the distance to the wall sphere.
  double contact_share(const WallTouch& touch, std::size_t body, const ContactScene& scene) const {
    const double distance = length(touch.separation), overlap = reach(scene, body) - distance;
    return (radius_ - 0.5 * overlap) / distance;
  }

  void pack(const Block& block, std::size_t body, const WallTouch& touch, const ContactScene& scene,
            std::size_t lane, Batch& batch) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    const BodyMotion& pose = scene.body_motion[body];
    const Vector3 here = scene.spheres.position(pair.own);
    const Eigen::Vector3d separation = pose.rotation * eigen(touch.separation);
    const Eigen::Vector3d contact = eigen(here) - contact_share(touch, body, scene) * separation;
    batch.separation.set(lane, plain(separation));
    batch.velocity.set(lane, scene.spheres.velocity(pair.own) - plain(pose.velocity_at(contact)));
    if constexpr (kComposed) batch.place.set(lane, here - plain(block.reference));
    if constexpr (Lever<kArm>::kTurns) {
      const Vector3 spin = scene.spheres.spin(pair.own);
      batch.spin_sum.set(lane, spin);
      if constexpr (Law::kRolls) batch.relative_spin.set(lane, spin - plain(pose.angular_velocity));
    }
    recall(block.wall_pairs, touch.pair, batch, lane);
  }

  void hand_out(const Batch& batch, std::size_t lane, Block& block, std::size_t body, const WallTouch& touch,
                const ContactScene& scene, BlockTally& tally) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    ContactSum& own = block.sums[block.slot[pair.own]];
    const Vector3 force = batch.force[lane];
    own.add_force(force);
    if constexpr (Lever<kArm>::kTurns) own.add_moment(batch.moment[lane]);
    if constexpr (!kComposed && Lever<kArm>::kTurns)
      own.add_rolling_load(laws_[body].rolling_friction * batch.load[lane]);
    remember(batch, lane, block.wall_pairs, touch.pair);

    const Vector3 contact =
        scene.spheres.position(pair.own) - contact_share(touch, body, scene) * batch.separation[lane];
    tally.body_force[body] -= eigen(force);
    tally.body_torque[body] -= (eigen(contact) - scene.body_motion[body].translation).cross(eigen(force));
  }

  double radius_;
  std::vector<Law> laws_;  ///< one a body: R_eff differs with the radius of its spheres (OP-5)
};

}  // namespace

std::unique_ptr<PairLoop> make_wall_loop(const std::vector<ContactParameters>& parameters, LeverArm arm,
                                         SpringLimit limit, double sphere_radius, bool composed,
                                         const std::vector<double>& wall_radii) {
  // One loop for all bodies: it has the terms that any of them needs.
  ContactParameters any;
  for (const auto& body : parameters) {
    any.friction = std::max(any.friction, body.friction);
    any.work_of_adhesion = std::max(any.work_of_adhesion, body.work_of_adhesion);
  }
  return with_law(any, arm, limit,
                  [&]<class Law, class Arm>(std::type_identity<Law>, Arm) -> std::unique_ptr<PairLoop> {
                    std::vector<Law> laws;
                    for (std::size_t body = 0; body < wall_radii.size(); ++body)
                      laws.emplace_back(parameters[body], effective_radius(sphere_radius, wall_radii[body]));
                    if (composed)
                      return std::make_unique<WallLoop<Law, Arm::value, true>>(laws, sphere_radius);
                    return std::make_unique<WallLoop<Law, Arm::value, false>>(laws, sphere_radius);
                  });
}

std::unique_ptr<PairLoop> make_general_wall_loop(const GeneralContact& contact, LeverArm arm,
                                                 const GrainShape& shape,
                                                 const std::vector<double>& wall_radii) {
  laws::require_sensible(contact.walls);
  const double radius = shape.sphere_radius;
  std::vector<laws::GeneralContactLaw> laws;
  for (const double wall_radius : wall_radii) {
    laws.emplace_back(
        contact.walls, contact.scaling,
        laws::PairProperties{radius, wall_radius, shape.mass, std::numeric_limits<double>::infinity()});
    if (laws.back().range() > 0)
      throw std::invalid_argument(
          "walls attract only what touches them: give the wall law no distant attraction");
  }
  return with_arm(arm, [&]<class Arm>(Arm) -> std::unique_ptr<PairLoop> {
    if (shape.spheres() > 1)
      return std::make_unique<WallLoop<laws::GeneralContactLaw, Arm::value, true>>(laws, radius);
    return std::make_unique<WallLoop<laws::GeneralContactLaw, Arm::value, false>>(laws, radius);
  });
}

}  // namespace diefill::engine
