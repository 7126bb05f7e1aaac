#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

#include "engine/contact/contact_kernel.h"
#include "engine/contact/contact_workspace.h"
#include "engine/contact/mesh_contacts.h"
#include "engine/contact/pair_laws.h"

namespace diefill::engine {

namespace {

/// Pairs of grains with walls. `kClumps`: several spheres per grain, moments about the block's reference
/// point. `kSeveralClasses`: grains are of more than one type.
template <class Law, LeverArm kArm, bool kClumps, bool kSeveralClasses = false>
class WallLoop final : public PairLoop {
 public:
  /// `laws`: one per class for each body, body after body; `radii`: m, of the classes; `surfaces`: of the
  /// bodies.
  WallLoop(std::vector<Law> laws, std::vector<double> radii, std::vector<WallSurface> surfaces)
      : radii_(std::move(radii)), laws_(std::move(laws)), surfaces_(std::move(surfaces)) {}

  void add_forces(Block& block, const ContactScene& scene, ContactWorkspace& workspace,
                  BlockTally& tally) const override {
    if (block.wall_pairs.size() == 0) return;
    Batch batch;
    if constexpr (!Lever<kArm>::kTurns && Law::kRolls) batch.set_no_spins();
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      if (block.wall_first[body] < block.wall_first[body + 1])
        add_body(block, body, scene, batch, workspace, tally);
  }

  void visit_forces(const Block& block, const ContactScene& scene,
                    const PairForceVisitor& visit) const override {
    Batch batch;
    if constexpr (!Lever<kArm>::kTurns && Law::kRolls) batch.set_no_spins();
    batch.count = 1;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
      for (const std::uint32_t p :
           touching_pairs(block.wall_pairs, block.wall_first[body], block.wall_first[body + 1])) {
        const WallPair pair = block.wall_pairs.pair[p];
        const WallTouch touch{p, class_of(block, pair), separation_in_body(pair, body, scene)};
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
    MeshWorkspace mesh;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body) {
      if (scene.bodies[body].meshed()) {
        touches.clear();
        find_mesh_touches(mesh_pairs(block, body, scene), mesh, touches);
        for (const auto& touch : touches)
          energy += law(body, touch.sphere_class)
                        .energy(reach(scene, body, touch.sphere_class) - length(touch.separation),
                                block.wall_pairs.history_of(touch.pair));
        continue;
      }
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        const WallPair pair = block.wall_pairs.pair[p];
        const std::uint32_t own_class = class_of(block, pair);
        const double overlap = reach(scene, body, own_class) - length(separation_in_body(pair, body, scene));
        if (overlap > 0)
          energy += own_share(body) * law(body, own_class).energy(overlap, block.wall_pairs.history_of(p));
      }
    }
    return energy;
  }

  std::vector<double> history_signs() const override { return Law::history_signs(); }
  std::vector<HistoryLayout> history_layouts() const override {
    std::vector<HistoryLayout> layouts;
    for (const Law& law : laws_) layouts.push_back(law.history_layout());
    return layouts;
  }
  void clear_changed_history(Block& block, const std::vector<HistoryLayout>& next) const override {
    const auto before = history_layouts();
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        const std::size_t law = law_number(body, class_of(block, block.wall_pairs.pair[p]));
        clear_changed(block.wall_pairs.history_of(p), before[law], next[law]);
      }
  }
  bool rolls() const override {
    return !kClumps && Lever<kArm>::kTurns &&
           std::any_of(laws_.begin(), laws_.end(), [](const Law& any) { return any.rolling_friction != 0; });
  }
  double range() const override { return 0; }

 private:
  using Batch = ContactBatch<Law>;

  /// Of the pair's sphere.
  static std::uint32_t class_of(const Block& block, const WallPair& pair) {
    return kSeveralClasses ? block.sphere_class[pair.own] : 0;
  }
  std::size_t law_number(std::size_t body, std::uint32_t own_class) const {
    return kSeveralClasses ? body * radii_.size() + own_class : body;
  }
  const Law& law(std::size_t body, std::uint32_t own_class) const {
    return laws_[law_number(body, own_class)];
  }
  double reach(const ContactScene& scene, std::size_t body, std::uint32_t own_class) const {
    return radii_[own_class] + (mirror(body) ? radii_[own_class] : scene.bodies[body].sphere_radius());
  }
  bool mirror(std::size_t body) const { return surfaces_[body].mirror; }
  /// Of a contact's energy, work and overlap: at a plane of symmetry half belongs to the image.
  double own_share(std::size_t body) const { return mirror(body) ? 0.5 : 1; }
  void react_all(Batch& batch, std::size_t body, const ContactScene& scene, double time_step) const {
    const LawOfPair<Law> first{law(body, 0), {reach(scene, body, 0), radii_[0]}};
    react<kArm, kClumps, false, kSeveralClasses>(
        batch,
        [&](std::size_t lane) {
          if constexpr (!kSeveralClasses) return first;
          const std::uint32_t own_class = batch.classes[lane];
          return LawOfPair<Law>{law(body, own_class), {reach(scene, body, own_class), radii_[own_class]}};
        },
        scene.instructions, time_step);
  }

  MeshPairs mesh_pairs(const Block& block, std::size_t body, const ContactScene& scene) const {
    return {block, body, scene.bodies[body], scene.body_motion[body], scene.spheres, radii_};
  }

  /// m, body frame.
  static Eigen::Vector3d place_in_body(LocalSphere own, std::size_t body, const ContactScene& scene) {
    const BodyMotion& pose = scene.body_motion[body];
    return pose.rotation.transpose() * (eigen(scene.spheres.position(own)) - pose.translation);
  }

  /// Centre of a grain's sphere at `place` (m) seen from a wall sphere, in the body's frame. From a plane or
  /// triangle, its nearest point stands for the wall sphere; from a plane of symmetry the sphere's own image.
  Vector3 separation_from_part(std::size_t body, std::uint32_t part, const Eigen::Vector3d& place,
                               const ContactScene& scene) const {
    const WallBody& wall = scene.bodies[body];
    if (!wall.flat() && !wall.meshed()) return plain(Eigen::Vector3d(place - wall.centres()[part]));
    if (wall.meshed()) return plain(separation_from_triangle(wall, part, place, scene.sphere_radius));
    const WallPlane& plane = wall.planes()[part];
    // A centre on the plane still has a side to be pushed to.
    const double height = std::max(plane.normal.dot(place - plane.point), 1e-9 * scene.sphere_radius);
    return plain(Eigen::Vector3d((mirror(body) ? 2 * height : height) * plane.normal));
  }

  Vector3 separation_in_body(const WallPair& pair, std::size_t body, const ContactScene& scene) const {
    return separation_from_part(body, pair.wall, place_in_body(pair.own, body, scene), scene);
  }

  /// Into `workspace`.
  void find_touching(Block& block, std::size_t body, const ContactScene& scene, ContactWorkspace& workspace,
                     BlockTally& tally) const {
    std::vector<WallTouch>& touching = workspace.wall_touching;
    touching.clear();
    if (scene.bodies[body].meshed()) {
      const MeshPairs near = mesh_pairs(block, body, scene);
      const DeepestOnMesh deepest = update_mesh_touches(block.wall_pairs, near, workspace.mesh, touching);
      tally.overlap.walls = std::max(tally.overlap.walls, deepest.overlap);
      tally.overlap.walls_over_radius = std::max(tally.overlap.walls_over_radius, deepest.over_radius);
      return;
    }
    for (std::uint32_t r = block.wall_run_first[body]; r < block.wall_run_first[body + 1]; ++r)
      find_touching_of_sphere(block, block.wall_runs[r], block.wall_runs[r + 1].first, body, scene, touching);
  }

  /// The touching pairs of one run, which ends before pair `end`.
  void find_touching_of_sphere(Block& block, const WallRun& run, std::uint32_t end, std::size_t body,
                               const ContactScene& scene, std::vector<WallTouch>& touching) const {
    const Eigen::Vector3d place = place_in_body(run.own, body, scene);
    const std::uint32_t own_class = kSeveralClasses ? block.sphere_class[run.own] : 0;
    const double limit = reach(scene, body, own_class) + law(body, own_class).range();
    const double within = run.within(plain(place), limit);
    std::uint32_t p = run.first;
    for (; p < end && block.wall_distance[p] < within; ++p) {
      const Vector3 between = separation_from_part(body, block.wall_pairs.pair[p].wall, place, scene);
      const bool touches = dot(between, between) < limit * limit;
      note_touching(block.wall_pairs, p, touches);
      if (touches) touching.push_back({p, own_class, between});
    }
    std::fill(block.wall_pairs.touching.data() + p, block.wall_pairs.touching.data() + end, std::uint8_t{0});
  }

  void add_body(Block& block, std::size_t body, const ContactScene& scene, Batch& batch,
                ContactWorkspace& workspace, BlockTally& tally) const {
    find_touching(block, body, scene, workspace, tally);
    const std::vector<WallTouch>& touching = workspace.wall_touching;
    BatchTally<Law> batches;
    for (std::size_t done = 0; done < touching.size(); done += batch.count) {
      batch.count = std::min(touching.size() - done, Batch::kLanes);
      const WallTouch* pairs = touching.data() + done;
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        pack(block, body, pairs[lane], scene, lane, batch);
      batch.fill_last_group();
      with_instructions(scene.instructions, [&] { react_all(batch, body, scene, scene.time_step); });
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        add_reactions(batch, lane, block, body, pairs[lane], scene, workspace.sums, tally);
      batches.add(batch);
      if constexpr (kSeveralClasses)
        batches.add_over_radius(batch, [&](std::size_t lane) { return radii_[batch.classes[lane]]; });
    }
    const double share = own_share(body);
    batches.add_to(tally, share * scene.time_step);
    tally.overlap.walls = std::max(tally.overlap.walls, share * batches.deepest());
    const double over_radius =
        kSeveralClasses ? batches.deepest_over_radius() : batches.deepest() / radii_[0];
    tally.overlap.walls_over_radius = std::max(tally.overlap.walls_over_radius, share * over_radius);
  }

  /// Way from the grain sphere's centre to the middle of the overlap, over the distance to the wall sphere.
  double contact_share(const WallTouch& touch, std::size_t body, const ContactScene& scene) const {
    const double distance = length(touch.separation),
                 overlap = reach(scene, body, touch.sphere_class) - distance;
    return (radii_[touch.sphere_class] - 0.5 * overlap) / distance;
  }

  void pack(const Block& block, std::size_t body, const WallTouch& touch, const ContactScene& scene,
            std::size_t lane, Batch& batch) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    const BodyMotion& pose = scene.body_motion[body];
    const Vector3 here = scene.spheres.position(pair.own);
    const Eigen::Vector3d separation = pose.rotation * eigen(touch.separation);
    const Eigen::Vector3d contact = eigen(here) - contact_share(touch, body, scene) * separation;
    if constexpr (kSeveralClasses) batch.classes[lane] = touch.sphere_class;
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
    if (mirror(body)) use_motion_against_image(batch, lane);
    load_history(block.wall_pairs.history_of(touch.pair), batch, lane);
  }

  /// Makes the motion against a plane of symmetry that against the grain's image: it comes as fast from the
  /// other side, slides along, and spins the same way about the normal and the opposite way across it.
  static void use_motion_against_image(Batch& batch, std::size_t lane) {
    const Vector3 separation = batch.separation[lane], velocity = batch.velocity[lane];
    const double squared = dot(separation, separation);
    batch.velocity.set(lane, 2 * dot(velocity, separation) / squared * separation);
    if constexpr (Lever<kArm>::kTurns) {
      const Vector3 spin = batch.spin_sum[lane];
      const Vector3 along = dot(spin, separation) / squared * separation;
      batch.spin_sum.set(lane, 2.0 * along);
      if constexpr (Law::kRolls) batch.relative_spin.set(lane, 2.0 * (spin - along));
    }
  }

  void add_reactions(const Batch& batch, std::size_t lane, Block& block, std::size_t body,
                     const WallTouch& touch, const ContactScene& scene, std::vector<ContactSum>& sums,
                     BlockTally& tally) const {
    const WallPair pair = block.wall_pairs.pair[touch.pair];
    ContactSum& own = sums[block.slot_of<kClumps>(pair.own)];
    const Vector3 force = batch.force[lane];
    own.add_force(force);
    if constexpr (Lever<kArm>::kTurns) own.add_moment(batch.moment[lane]);
    if constexpr (!kClumps && Lever<kArm>::kTurns)
      own.add_rolling_load(law(body, touch.sphere_class).rolling_friction * batch.load[lane]);
    store_history(batch, lane, block.wall_pairs.history_of(touch.pair));

    const Vector3 contact =
        scene.spheres.position(pair.own) - contact_share(touch, body, scene) * batch.separation[lane];
    tally.body_force[body] -= eigen(force);
    tally.body_torque[body] -= (eigen(contact) - scene.body_motion[body].translation).cross(eigen(force));
  }

  std::vector<double> radii_;  ///< m, of the classes of spheres
  std::vector<Law> laws_;      ///< R_eff differs with the radius of a body's spheres (OP-5)
  std::vector<WallSurface> surfaces_;
};

/// Bierwisch's law of each surface; nothing where any is another.
std::vector<laws::BierwischLaw> tuned_laws(const ParticleTypes& types, const ContactLaws& contact,
                                           const std::vector<WallSurface>& surfaces) {
  std::vector<laws::BierwischLaw> laws;
  for (const WallSurface& surface : surfaces) {
    const auto law = tuned_law(types, contact, surface.mirror ? types.material(0) : surface.material);
    if (!law || (!laws.empty() && law->spring_limit != laws.front().spring_limit)) return {};
    laws.push_back(*law);
  }
  return laws;
}

/// The tuned loop of grains of one type: one for all bodies, with the terms that any of them needs.
std::unique_ptr<PairLoop> make_tuned_loop(const std::vector<laws::BierwischLaw>& surface_laws,
                                          const std::vector<WallSurface>& surfaces,
                                          const ParticleTypes& types, LeverArm arm) {
  ContactParameters any;
  for (const auto& law : surface_laws) {
    any.friction = std::max(any.friction, law.parameters.friction);
    any.work_of_adhesion = std::max(any.work_of_adhesion, law.parameters.work_of_adhesion);
  }
  const double radius = types.shape(0).sphere_radius;
  return with_law(any, arm, types.clumps(), surface_laws.front().spring_limit,
                  [&]<class Law, class Arm, class Clumps>(std::type_identity<Law>, Arm,
                                                          Clumps) -> std::unique_ptr<PairLoop> {
                    std::vector<Law> laws;
                    for (std::size_t body = 0; body < surfaces.size(); ++body)
                      laws.emplace_back(
                          surface_laws[body].parameters,
                          effective_radius(radius, surfaces[body].mirror ? radius : surfaces[body].radius));
                    return std::make_unique<WallLoop<Law, Arm::value, Clumps::value>>(
                        laws, std::vector{radius}, surfaces);
                  });
}

}  // namespace

std::unique_ptr<PairLoop> make_wall_loop(const ParticleTypes& types, const ContactLaws& contact, LeverArm arm,
                                         const std::vector<WallSurface>& surfaces) {
  using Law = laws::GeneralContactLaw;
  if (const auto tuned = tuned_laws(types, contact, surfaces); !tuned.empty())
    return make_tuned_loop(tuned, surfaces, types, arm);
  std::vector<Law> laws;
  for (const WallSurface& surface : surfaces)
    for (std::size_t own = 0; own < types.classes().size(); ++own)
      laws.push_back(law_at_wall(types, contact, static_cast<ClassNumber>(own), surface));
  return with_arm(arm, types.clumps(),
                  [&]<class Arm, class Clumps>(Arm, Clumps) -> std::unique_ptr<PairLoop> {
                    using OneClass = WallLoop<Law, Arm::value, Clumps::value>;
                    using SeveralClasses = WallLoop<Law, Arm::value, Clumps::value, true>;
                    if (types.classes().size() == 1)
                      return std::make_unique<OneClass>(laws, types.sphere_radii(), surfaces);
                    return std::make_unique<SeveralClasses>(laws, types.sphere_radii(), surfaces);
                  });
}

}  // namespace diefill::engine
