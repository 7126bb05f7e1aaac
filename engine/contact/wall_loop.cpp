#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

#include "engine/contact/contact_kernel.h"
#include "engine/contact/mesh_contacts.h"
#include "engine/contact/pair_laws.h"

namespace diefill::engine {

namespace {

/// Pairs of grains with walls. `kComposed`: several spheres a grain, moments about the block's reference
/// point. `kKinds`: grains are not all alike.
template <class Law, LeverArm kArm, bool kClumps, bool kKinds = false>
class WallLoop final : public PairLoop {
 public:
  /// `laws`: one a kind for each body, body after body; `radii`: m, of the kinds' spheres.
  WallLoop(std::vector<Law> laws, std::vector<double> radii)
      : radii_(std::move(radii)), laws_(std::move(laws)) {}

  void add_forces(Block& block, const ContactScene& scene, std::vector<ContactSum>& sums,
                  BlockTally& tally) const override {
    if (block.wall_pairs.size() == 0) return;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      if (block.wall_first[body] < block.wall_first[body + 1]) add_body(block, body, scene, sums, tally);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    Batch& batch = batch_of_thread<Batch>();
    batch.count = 1;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
      for (const std::uint32_t p :
           touching_pairs(block.wall_pairs, block.wall_first[body], block.wall_first[body + 1])) {
        const WallPair pair = block.wall_pairs.pair[p];
        const WallTouch touch{p, kind_of(block, pair), separation_in_body(pair, body, scene)};
        pack(block, body, touch, scene, 0, batch);
        batch.fill_last_group();
        react_all(batch, body, scene, 0);
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
        find_mesh_touches(mesh_pairs(block, body, scene), touches);
        for (const auto& touch : touches)
          energy += law(body, 0).energy(reach(scene, body, 0) - length(touch.separation),
                                        block.wall_pairs.history_of(touch.pair));
        continue;
      }
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        const WallPair pair = block.wall_pairs.pair[p];
        const std::uint32_t kind = kind_of(block, pair);
        const double overlap = reach(scene, body, kind) - length(separation_in_body(pair, body, scene));
        if (overlap > 0) energy += law(body, kind).energy(overlap, block.wall_pairs.history_of(p));
      }
    }
    return energy;
  }

  std::vector<double> history_signs() const override { return Law::history_signs(); }
  bool rolls() const override {
    return !kClumps && Lever<kArm>::kTurns &&
           std::any_of(laws_.begin(), laws_.end(), [](const Law& any) { return any.rolling_friction != 0; });
  }
  double range() const override { return 0; }

 private:
  using Batch = ContactBatch<Law>;

  /// Of the pair's grain.
  static std::uint32_t kind_of(const Block& block, const WallPair& pair) {
    return kKinds ? block.kind[pair.own] : 0;
  }
  const Law& law(std::size_t body, std::uint32_t kind) const {
    return laws_[kKinds ? body * radii_.size() + kind : body];
  }
  double reach(const ContactScene& scene, std::size_t body, std::uint32_t kind) const {
    return radii_[kind] + scene.bodies[body].sphere_radius();
  }
  void react_all(Batch& batch, std::size_t body, const ContactScene& scene, double time_step) const {
    const LawOfPair<Law> first{law(body, 0), {reach(scene, body, 0), radii_[0]}};
    react<kArm, kClumps>(
        batch,
        [&](std::size_t lane) {
          if constexpr (!kKinds) return first;
          const std::uint32_t kind = batch.kinds[lane];
          return LawOfPair<Law>{law(body, kind), {reach(scene, body, kind), radii_[kind]}};
        },
        scene.instructions, time_step);
  }

  MeshPairs mesh_pairs(const Block& block, std::size_t body, const ContactScene& scene) const {
    return {block, body, scene.bodies[body], scene.body_motion[body], scene.spheres, radii_[0]};
  }

  /// m, body frame.
  static Eigen::Vector3d place_in_body(LocalSphere own, std::size_t body, const ContactScene& scene) {
    const BodyMotion& pose = scene.body_motion[body];
    return pose.rotation.transpose() * (eigen(scene.spheres.position(own)) - pose.translation);
  }

  /// Centre of a grain's sphere at `place` (m) seen from a wall sphere, in the body's frame. From a plane or
  /// triangle, its nearest point stands for the wall sphere.
  static Vector3 separation_from_part(const WallBody& wall, std::uint32_t part, const Eigen::Vector3d& place,
                                      const ContactScene& scene) {
    if (!wall.flat() && !wall.meshed()) return plain(Eigen::Vector3d(place - wall.centres()[part]));
    if (wall.meshed()) return plain(separation_from_triangle(wall, part, place, scene.sphere_radius));
    const WallPlane& plane = wall.planes()[part];
    // A centre on the plane still has a side to be pushed to.
    const double height = std::max(plane.normal.dot(place - plane.point), 1e-9 * scene.sphere_radius);
    return plain(Eigen::Vector3d(height * plane.normal));
  }

  static Vector3 separation_in_body(const WallPair& pair, std::size_t body, const ContactScene& scene) {
    return separation_from_part(scene.bodies[body], pair.wall, place_in_body(pair.own, body, scene), scene);
  }

  void find_touching(Block& block, std::size_t body, const ContactScene& scene,
                     std::vector<WallTouch>& touching, BlockTally& tally) const {
    touching.clear();
    if (scene.bodies[body].meshed()) {
      const MeshPairs near = mesh_pairs(block, body, scene);
      const double deepest = find_mesh_touches(near, touching);
      tally.overlap.walls = std::max(tally.overlap.walls, deepest);
      tally.overlap.walls_over_radius = std::max(tally.overlap.walls_over_radius, deepest / radii_[0]);
      return note_mesh_touches(block.wall_pairs, near, touching);
    }
    for (std::uint32_t r = block.wall_run_first[body]; r < block.wall_run_first[body + 1]; ++r)
      find_touching_of_sphere(block, block.wall_runs[r], block.wall_runs[r + 1].first, body, scene, touching);
  }

  /// The touching pairs of one run, which ends before pair `end`.
  void find_touching_of_sphere(Block& block, const WallRun& run, std::uint32_t end, std::size_t body,
                               const ContactScene& scene, std::vector<WallTouch>& touching) const {
    const WallBody& wall = scene.bodies[body];
    const Eigen::Vector3d place = place_in_body(run.own, body, scene);
    const std::uint32_t kind = kKinds ? block.kind[run.own] : 0;
    const double limit = reach(scene, body, kind);
    const double within = run.within(plain(place), limit);
    std::uint32_t p = run.first;
    for (; p < end && block.wall_distance[p] < within; ++p) {
      const Vector3 between = separation_from_part(wall, block.wall_pairs.pair[p].wall, place, scene);
      const bool touches = dot(between, between) < limit * limit;
      note_touching(block.wall_pairs, p, touches);
      if (touches) touching.push_back({p, kind, between});
    }
    std::fill(block.wall_pairs.touching.data() + p, block.wall_pairs.touching.data() + end, std::uint8_t{0});
  }

  void add_body(Block& block, std::size_t body, const ContactScene& scene, std::vector<ContactSum>& sums,
                BlockTally& tally) const {
    thread_local std::vector<WallTouch> touching;
    find_touching(block, body, scene, touching, tally);
    Batch& batch = batch_of_thread<Batch>();
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < touching.size(); done += batch.count) {
      batch.count = std::min(touching.size() - done, Batch::kLanes);
      const WallTouch* pairs = touching.data() + done;
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        pack(block, body, pairs[lane], scene, lane, batch);
      batch.fill_last_group();
      with_instructions(scene.instructions, [&] { react_all(batch, body, scene, scene.time_step); });
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        hand_out(batch, lane, block, body, pairs[lane], scene, sums, tally);
      batches.add(batch);
      if constexpr (kKinds)
        batches.add_over_radius(batch, [&](std::size_t lane) { return radii_[batch.kinds[lane]]; });
    }
    batches.book(scene.time_step, tally);
    tally.overlap.walls = std::max(tally.overlap.walls, batches.deepest());
    const double over_radius = kKinds ? batches.deepest_over_radius() : batches.deepest() / radii_[0];
    tally.overlap.walls_over_radius = std::max(tally.overlap.walls_over_radius, over_radius);
  }

  /// Way from the grain sphere's centre to the middle of the overlap, over the distance to the wall sphere.
  double contact_share(const WallTouch& touch, std::size_t body, const ContactScene& scene) const {
    const double distance = length(touch.separation), overlap = reach(scene, body, touch.kind) - distance;
    return (radii_[touch.kind] - 0.5 * overlap) / distance;
  }

  void pack(const Block& block, std::size_t body, const WallTouch& touch, const ContactScene& scene,
            std::size_t lane, Batch& batch) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    const BodyMotion& pose = scene.body_motion[body];
    const Vector3 here = scene.spheres.position(pair.own);
    const Eigen::Vector3d separation = pose.rotation * eigen(touch.separation);
    const Eigen::Vector3d contact = eigen(here) - contact_share(touch, body, scene) * separation;
    if constexpr (kKinds) batch.kinds[lane] = touch.kind;
    batch.separation.set(lane, plain(separation));
    const std::size_t slot = block.slot_of<kClumps>(pair.own);
    const Vector3 spin = scene.spheres.spin(slot);
    Vector3 velocity = scene.spheres.velocity(slot);
    if constexpr (kClumps) {
      const Vector3 place = here - plain(block.reference);
      velocity += cross(spin, place);
      batch.place.set(lane, place);
    }
    batch.velocity.set(lane, velocity - plain(pose.velocity_at(contact)));
    if constexpr (Lever<kArm>::kTurns) {
      batch.spin_sum.set(lane, spin);
      if constexpr (Law::kRolls) batch.relative_spin.set(lane, spin - plain(pose.angular_velocity));
    }
    recall(block.wall_pairs.history_of(touch.pair), batch, lane);
  }

  void hand_out(const Batch& batch, std::size_t lane, Block& block, std::size_t body, const WallTouch& touch,
                const ContactScene& scene, std::vector<ContactSum>& sums, BlockTally& tally) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    ContactSum& own = sums[block.slot_of<kClumps>(pair.own)];
    const Vector3 force = batch.force[lane];
    own.add_force(force);
    if constexpr (Lever<kArm>::kTurns) own.add_moment(batch.moment[lane]);
    if constexpr (!kClumps && Lever<kArm>::kTurns)
      own.add_rolling_load(law(body, touch.kind).rolling_friction * batch.load[lane]);
    remember(batch, lane, block.wall_pairs.history_of(touch.pair));

    const Vector3 contact =
        scene.spheres.position(pair.own) - contact_share(touch, body, scene) * batch.separation[lane];
    tally.body_force[body] -= eigen(force);
    tally.body_torque[body] -= (eigen(contact) - scene.body_motion[body].translation).cross(eigen(force));
  }

  std::vector<double> radii_;  ///< m, of the kinds' spheres
  std::vector<Law> laws_;      ///< R_eff differs with the radius of a body's spheres (OP-5)
};

}  // namespace

std::unique_ptr<PairLoop> make_wall_loop(const std::vector<ContactParameters>& parameters, LeverArm arm,
                                         SpringLimit limit, double sphere_radius, bool clumps,
                                         const std::vector<double>& wall_radii) {
  // One loop for all bodies: it has the terms that any of them needs.
  ContactParameters any;
  for (const auto& body : parameters) {
    any.friction = std::max(any.friction, body.friction);
    any.work_of_adhesion = std::max(any.work_of_adhesion, body.work_of_adhesion);
  }
  return with_law(any, arm, clumps, limit,
                  [&]<class Law, class Arm, class Clumps>(std::type_identity<Law>, Arm,
                                                          Clumps) -> std::unique_ptr<PairLoop> {
                    std::vector<Law> laws;
                    for (std::size_t body = 0; body < wall_radii.size(); ++body)
                      laws.emplace_back(parameters[body], effective_radius(sphere_radius, wall_radii[body]));
                    return std::make_unique<WallLoop<Law, Arm::value, Clumps::value>>(
                        laws, std::vector{sphere_radius});
                  });
}

std::unique_ptr<PairLoop> make_general_wall_loop(const GeneralContact& contact, LeverArm arm,
                                                 const GrainShape& shape,
                                                 const std::vector<double>& wall_radii) {
  using Law = laws::GeneralContactLaw;
  laws::require_sensible(contact.walls);
  const double radius = shape.sphere_radius;
  std::vector<Law> laws;
  for (const double wall_radius : wall_radii) {
    laws.emplace_back(
        contact.walls, contact.scaling,
        laws::PairProperties{radius, wall_radius, shape.mass, std::numeric_limits<double>::infinity()});
    if (laws.back().range() > 0)
      throw std::invalid_argument(
          "walls attract only what touches them: give the wall law no distant attraction");
  }
  return with_arm(
      arm, shape.spheres() > 1, [&]<class Arm, class Clumps>(Arm, Clumps) -> std::unique_ptr<PairLoop> {
        return std::make_unique<WallLoop<Law, Arm::value, Clumps::value>>(laws, std::vector{radius});
      });
}

std::unique_ptr<PairLoop> make_mixed_wall_loop(const KindTable& kinds, const GrainMix& mix, LeverArm arm,
                                               const std::vector<double>& wall_radii,
                                               const std::vector<std::string>& wall_materials) {
  using Law = laws::GeneralContactLaw;
  std::vector<Law> laws;
  for (std::size_t body = 0; body < wall_radii.size(); ++body)
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
      laws.push_back(
          law_with_wall(kinds, mix, static_cast<KindNumber>(kind), wall_materials[body], wall_radii[body]));
  return with_arm(arm, kinds.clumps(),
                  [&]<class Arm, class Clumps>(Arm, Clumps) -> std::unique_ptr<PairLoop> {
                    using Monodisperse = WallLoop<Law, Arm::value, Clumps::value>;
                    using Kinds = WallLoop<Law, Arm::value, Clumps::value, true>;
                    if (kinds.monodisperse())
                      return std::make_unique<Monodisperse>(laws, kinds.sphere_radii());
                    return std::make_unique<Kinds>(laws, kinds.sphere_radii());
                  });
}

}  // namespace diefill::engine
