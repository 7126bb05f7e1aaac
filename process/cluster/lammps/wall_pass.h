// Contacts of a rank's own grains with tools: every rank knows all wall spheres and where the tools are, so
// that none is an atom. Law and batches are the engine's.
#pragma once

#include "engine/contact/sphere_on_mesh.h"
#include "process/cluster/lammps/memory_record.h"
#include "process/cluster/lammps/near_pairs.h"

namespace diefill::process::cluster {

/// One law for each body and class of spheres.
template <class Law, engine::LeverArm kArm, bool kClumps>
class WallPass final : public ContactPass {
 public:
  /// `laws`: body after body, one for each class of spheres.
  WallPass(std::vector<Law> laws, const PowderModel& model)
      : laws_(std::move(laws)), near_(model.bodies.size()) {
    for (const auto& sphere : model.types.classes()) radius_.push_back(sphere.radius);
    for (auto& pairs : near_) pairs.width = Batch::kHistory;
  }

  void search(const RankGrains& grains, const NearGrains&) override {
    const PowderModel& model = grains.model;
    for (std::size_t body = 0; body < near_.size(); ++body) {
      near_[body].clear();
      const bool flat = model.bodies[body].flat();
      for (std::size_t grain = 0; grain < grains.own; ++grain)
        for (std::uint32_t s = 0; s < grains.spheres_of(grain); ++s) {
          const std::uint32_t sphere = static_cast<std::uint32_t>(grain * model.spheres()) + s;
          const std::uint32_t own_class = grains.class_of(grain, s);
          // Flat walls search by height; the distance to the image behind a symmetry plane is twice that
          // height.
          const double reach = (flat ? radius_[own_class] : reach_of(model, body, own_class)) + model.skin +
                               law(body, own_class).range();
          found_.clear();
          model.bodies[body].find(place_in_body(grains, sphere, body), reach, found_);
          for (const std::uint32_t part : found_)
            near_[body].add({sphere, part},
                            MemoryRecord::find(grains.memory[grain], MemoryRecord::body_key(body), s,
                                               model.wall_number[body][part]));
        }
    }
  }

  void add_forces(RankGrains& grains, ContactFigures& figures) override {
    for (std::size_t body = 0; body < near_.size(); ++body)
      if (!near_[body].pair.empty()) add_body(grains, body, figures);
  }

  void store_history(RankGrains& grains) const override {
    for_touching(grains, [&](std::size_t body, std::size_t p, std::size_t grain, std::uint32_t number) {
      const NearPairs& near = near_[body];
      MemoryRecord::append(grains.memory[grain], MemoryRecord::body_key(body), number,
                           grains.model.wall_number[body][near.pair[p].other], near.history_of(p),
                           near.width);
    });
  }

  void name_contacts(const RankGrains& grains, engine::NamedContacts& named) const override {
    std::vector<std::uint64_t> first(1, 0);
    for (const auto& body : grains.model.bodies) first.push_back(first.back() + body.size());
    for_touching(grains, [&](std::size_t body, std::size_t p, std::size_t grain, std::uint32_t number) {
      const NearPairs& near = near_[body];
      named.pair.push_back({static_cast<std::uint64_t>(grains.tag[grain] - 1),
                            first[body] + grains.model.wall_number[body][near.pair[p].other], number, 0});
      named.history.insert(named.history.end(), near.history_of(p), near.history_of(p) + near.width);
    });
  }

  std::vector<double> history_signs() const override { return Law::history_signs(); }
  bool rolls() const override {
    return !kClumps && kTurns &&
           std::any_of(laws_.begin(), laws_.end(), [](const Law& any) { return any.rolling_friction != 0; });
  }

 private:
  using Batch = engine::ContactBatch<Law>;
  static constexpr bool kTurns = engine::Lever<kArm>::kTurns;

  /// A touching pair: its place in the list, and the grain sphere's centre seen from the wall sphere in the
  /// frame of the body (m); from a plane or triangle its nearest point stands for the wall sphere, from a
  /// plane of symmetry the sphere's own image.
  struct Touch {
    std::uint32_t pair;
    engine::Vector3 separation;
  };

  const Law& law(std::size_t body, std::uint32_t own_class) const {
    return laws_[body * radius_.size() + own_class];
  }
  double reach_of(const PowderModel& model, std::size_t body, std::uint32_t own_class) const {
    return radius_[own_class] +
           (model.bodies[body].mirror() ? radius_[own_class] : model.bodies[body].sphere_radius());
  }
  static std::size_t grain_of(const RankGrains& grains, std::uint32_t sphere) {
    if constexpr (!kClumps) return sphere;
    return sphere / grains.model.spheres();
  }
  static std::uint32_t class_of(const RankGrains& grains, std::uint32_t sphere) {
    if (grains.model.types.classes().size() == 1) return 0;
    return grains.class_of(grain_of(grains, sphere), sphere % grains.model.spheres());
  }
  static Eigen::Vector3d place_in_body(const RankGrains& grains, std::uint32_t sphere, std::size_t body) {
    const engine::BodyMotion& pose = grains.body_motion[body];
    return pose.rotation.transpose() * (engine::eigen(grains.sphere[sphere]) - pose.translation);
  }

  template <class Visit>
  void for_touching(const RankGrains& grains, const Visit& visit) const {
    for (std::size_t body = 0; body < near_.size(); ++body)
      for (std::size_t p = 0; p < near_[body].pair.size(); ++p) {
        if (!near_[body].touching[p]) continue;
        const std::uint32_t sphere = near_[body].pair[p].own;
        visit(body, p, grain_of(grains, sphere), static_cast<std::uint32_t>(sphere % grains.model.spheres()));
      }
  }

  static engine::Vector3 separation_from_part(const PowderModel& model, std::size_t body, std::uint32_t part,
                                              const Eigen::Vector3d& place) {
    const engine::WallBody& wall = model.bodies[body];
    if (!wall.flat()) return engine::plain(Eigen::Vector3d(place - wall.centres()[part]));
    const engine::WallPlane& plane = wall.planes()[part];
    // A centre on the plane still has a side to be pushed to.
    const double height =
        std::max(plane.normal.dot(place - plane.point), 1e-9 * model.types.smallest_sphere());
    return engine::plain(Eigen::Vector3d((wall.mirror() ? 2 * height : height) * plane.normal));
  }

  void find_touching(const RankGrains& grains, std::size_t body, engine::DeepestOverlap& deepest) {
    touches_.clear();
    const NearPairs& near = near_[body];
    const bool meshed = grains.model.bodies[body].meshed();
    for (std::uint32_t p = 0, end = 0; p < near.pair.size(); p = end) {
      while (end < near.pair.size() && near.pair[end].own == near.pair[p].own) ++end;
      if (meshed)
        find_touching_triangles(grains, body, p, end, deepest);
      else
        find_touching_parts(grains, body, p, end);
    }
  }

  /// Among the near pairs [p, end), which are of one sphere.
  void find_touching_parts(const RankGrains& grains, std::size_t body, std::uint32_t p, std::uint32_t end) {
    NearPairs& near = near_[body];
    const std::uint32_t sphere = near.pair[p].own, own_class = class_of(grains, sphere);
    const Eigen::Vector3d place = place_in_body(grains, sphere, body);
    const double limit = reach_of(grains.model, body, own_class) + law(body, own_class).range();
    for (; p < end; ++p) {
      const engine::Vector3 between = separation_from_part(grains.model, body, near.pair[p].other, place);
      const bool touches = dot(between, between) < limit * limit;
      if (touches != static_cast<bool>(near.touching[p])) near.note(p, touches);
      if (touches) touches_.push_back({p, between});
    }
  }

  void find_touching_triangles(const RankGrains& grains, std::size_t body, std::uint32_t begin,
                               std::uint32_t end, engine::DeepestOverlap& deepest) {
    NearPairs& near = near_[body];
    const double radius = radius_[class_of(grains, near.pair[begin].own)];
    engine::SphereOnMesh sphere(mesh_, grains.model.bodies[body],
                                place_in_body(grains, near.pair[begin].own, body), radius);
    for (std::uint32_t p = begin; p < end; ++p) sphere.add_triangle(p, near.pair[p].other);
    const auto touching = sphere.touches();
    for (const auto& touch : touching) touches_.push_back({touch.near, touch.separation});
    deepest.walls = std::max(deepest.walls, sphere.deepest());
    deepest.walls_over_radius = std::max(deepest.walls_over_radius, sphere.deepest() / radius);
    engine::note_triangle_touches(near, sphere, begin, end, touching, mesh_.touches_now);
  }

  void add_body(RankGrains& grains, std::size_t body, ContactFigures& figures) {
    find_touching(grains, body, figures.overlap);
    const PowderModel& model = grains.model;
    const double share = model.bodies[body].mirror() ? 0.5 : 1;  // half of a contact is the image's
    for (std::size_t done = 0; done < touches_.size(); done += batch_.count) {
      batch_.count = std::min(touches_.size() - done, Batch::kLanes);
      for (std::size_t lane = 0; lane < batch_.count; ++lane) pack(grains, body, touches_[done + lane], lane);
      batch_.fill_last_group();
      const auto set = model.settings.instructions;
      engine::with_instructions(set, [&] {
        engine::react<kArm, kClumps>(
            batch_,
            [&](std::size_t lane) {
              const std::uint32_t own_class = batch_.classes[lane];
              return engine::LawOfPair<Law>{law(body, own_class),
                                            {reach_of(model, body, own_class), radius_[own_class]}};
            },
            set, model.settings.time_step);
      });
      double weight[Batch::kLanes];
      for (std::size_t lane = 0; lane < batch_.count; ++lane) {
        weight[lane] = share;
        add_reactions(grains, body, touches_[done + lane], lane, figures.loads[body]);
        note_overlap(share, lane, figures.overlap);
      }
      book(batch_, weight, figures);
    }
  }

  /// Way from the grain sphere's centre to the middle of the overlap, over the distance to the wall sphere.
  double contact_share(const RankGrains& grains, std::size_t body, std::uint32_t own_class,
                       engine::Vector3 separation) const {
    const double distance = length(separation), overlap = reach_of(grains.model, body, own_class) - distance;
    return (radius_[own_class] - 0.5 * overlap) / distance;
  }

  void pack(const RankGrains& grains, std::size_t body, const Touch& touch, std::size_t lane) {
    const NearPair pair = near_[body].pair[touch.pair];
    const engine::BodyMotion& pose = grains.body_motion[body];
    const std::size_t grain = grain_of(grains, pair.own);
    const engine::Vector3 here = grains.sphere[pair.own], spin = grains.spin_of(grain);
    const Eigen::Vector3d separation = pose.rotation * engine::eigen(touch.separation);
    batch_.classes[lane] = class_of(grains, pair.own);
    const double share = contact_share(grains, body, batch_.classes[lane], touch.separation);
    const Eigen::Vector3d contact = engine::eigen(here) - share * separation;
    batch_.separation.set(lane, engine::plain(separation));
    engine::Vector3 velocity = grains.velocity_of(grain);
    if constexpr (kClumps) {
      const engine::Vector3 place = here - grains.centre(grain);
      velocity += cross(spin, place);
      batch_.place.set(lane, place);
    }
    batch_.velocity.set(lane, velocity - engine::plain(pose.velocity_at(contact)));
    batch_.spin_sum.set(lane, spin);
    batch_.relative_spin.set(lane, spin - engine::plain(pose.angular_velocity));
    if (grains.model.bodies[body].mirror()) use_motion_against_image(lane);
    engine::load_history(near_[body].history_of(touch.pair), batch_, lane);
  }

  /// Makes the motion against a plane of symmetry that against the grain's image: it comes as fast from the
  /// other side, slides along, and spins the same way about the normal and the opposite way across it.
  void use_motion_against_image(std::size_t lane) {
    const engine::Vector3 separation = batch_.separation[lane], velocity = batch_.velocity[lane];
    const double squared = dot(separation, separation);
    batch_.velocity.set(lane, 2 * dot(velocity, separation) / squared * separation);
    const engine::Vector3 spin = batch_.spin_sum[lane];
    const engine::Vector3 along = dot(spin, separation) / squared * separation;
    batch_.spin_sum.set(lane, 2.0 * along);
    batch_.relative_spin.set(lane, 2.0 * (spin - along));
  }

  void add_reactions(RankGrains& grains, std::size_t body, const Touch& touch, std::size_t lane,
                     engine::WallLoad& load) {
    const NearPair pair = near_[body].pair[touch.pair];
    const std::uint32_t own_class = batch_.classes[lane];
    const engine::Vector3 force = batch_.force[lane];
    engine::ContactSum& sum = grains.sums[grain_of(grains, pair.own)];
    sum.add_force(force);
    if constexpr (kTurns) sum.add_moment(batch_.moment[lane]);
    if constexpr (!kClumps && kTurns)
      sum.add_rolling_load(law(body, own_class).rolling_friction * batch_.load[lane]);
    engine::store_history(static_cast<const Batch&>(batch_), lane, near_[body].history_of(touch.pair));
    const engine::Vector3 contact =
        grains.sphere[pair.own] -
        contact_share(grains, body, own_class, touch.separation) * batch_.separation[lane];
    load.force -= engine::eigen(force);
    load.torque -=
        (engine::eigen(contact) - grains.body_motion[body].translation).cross(engine::eigen(force));
  }

  void note_overlap(double share, std::size_t lane, engine::DeepestOverlap& deepest) const {
    const double overlap = share * batch_.overlap[lane];
    deepest.walls = std::max(deepest.walls, overlap);
    deepest.walls_over_radius = std::max(deepest.walls_over_radius, overlap / radius_[batch_.classes[lane]]);
  }

  std::vector<Law> laws_;
  std::vector<double> radius_;   ///< m, of the classes of spheres
  std::vector<NearPairs> near_;  ///< of each body
  std::vector<std::uint32_t> found_;
  std::vector<Touch> touches_;
  engine::MeshWorkspace mesh_;
  Batch batch_{};
};

}  // namespace diefill::process::cluster
