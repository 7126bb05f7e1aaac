#include "engine/integrate/grain_integrator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/numerics/lanes.h"
#include "engine/numerics/prefetch.h"
#include "engine/powder/quaternion_lanes.h"

namespace diefill::engine {

namespace {

constexpr std::size_t kGrains = 16;  ///< grains worked on at a time
using Scalars = Lanes<kGrains>;
using Vectors = VectorLanes<kGrains>;

/// A few grains, one lane each; lanes beyond `count` repeat the last grain.
struct GrainLanes {
  std::size_t begin = 0, count = 0;
  Vectors position, velocity, force, spin, torque;
  QuaternionLanes<kGrains> orientation;

  std::size_t groups() const { return whole_groups(count); }
  /// The grain of a lane.
  std::size_t grain(std::size_t lane) const { return begin + std::min(lane, count - 1); }

  void load(const Grains& grains, std::size_t first, std::size_t end, bool rotates) {
    begin = first;
    count = std::min(kGrains, end - first);
    prefetch<kGrains>(first, grains.velocity, grains.force);
    if (rotates) prefetch<kGrains>(first, grains.spin, grains.torque, grains.orientation);
    for (std::size_t lane = 0; lane < groups(); ++lane) {
      const std::size_t k = grain(lane);
      velocity.set(lane, plain(grains.velocity[k]));
      force.set(lane, plain(grains.force[k]));
      if (!rotates) continue;
      spin.set(lane, plain(grains.spin[k]));
      torque.set(lane, plain(grains.torque[k]));
      orientation.set(lane, plain(grains.orientation[k]));
    }
  }
  /// Needed only until positions are at the end of the step.
  void load_positions(const Grains& grains) {
    prefetch<kGrains>(begin, grains.position);
    for (std::size_t lane = 0; lane < groups(); ++lane)
      position.set(lane, plain(grains.position[grain(lane)]));
  }
};

/// How advanced grains move.
struct Advanced {
  Vectors velocity, spin;  ///< predicted; spin in the laboratory frame
  Scalars way;             ///< m, as GrainIntegrator::advance() returns
};

/// Positions and predicted velocities at the end of the step of powder that drifted by `drifted` (m). Here
/// and below, `bodies` gives the constants of each lane's grain.
template <class Bodies>
void drift(GrainLanes& lanes, Advanced& out, const Bodies& bodies, double time_step, Vector3 drifted) {
  const std::size_t groups = lanes.groups();
  const auto& body = bodies.kept();
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < groups; ++lane) {
    const Vector3 acceleration = (1 / body.mass(lane)) * lanes.force[lane];
    const Vector3 before = lanes.position[lane];
    const Vector3 position =
        before + time_step * lanes.velocity[lane] + (0.5 * time_step * time_step) * acceleration;
    lanes.position.set(lane, position);
    out.way[lane] = length(position - before - drifted);
    out.velocity.set(lane, lanes.velocity[lane] + time_step * acceleration);
  }
}

/// Orientations and predicted spins at the end of the step.
template <class Bodies>
void turn(GrainLanes& lanes, Advanced& out, const Bodies& bodies, double time_step,
          double displacement_per_turn) {
  const std::size_t groups = lanes.groups();
  const auto& body = bodies.kept();
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < groups; ++lane) {
    const Vector3 rate = spin_rate(body.inertia(lane), lanes.spin[lane], lanes.torque[lane]);
    const PlainQuaternion orientation =
        advance_orientation(lanes.orientation[lane], lanes.spin[lane], rate, time_step);
    const PlainQuaternion turned = orientation - lanes.orientation[lane];
    out.way[lane] += displacement_per_turn * std::sqrt(dot(turned, turned));
    lanes.orientation.set(lane, orientation);
    out.spin.set(lane, rotation_of(orientation) * (lanes.spin[lane] + time_step * rate));
  }
}

/// New velocities from the forces before and after the step.
template <class Bodies>
void kick(GrainLanes& lanes, const Vectors& force, const Bodies& bodies, double time_step) {
  const std::size_t groups = lanes.groups();
  const auto& body = bodies.kept();
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < groups; ++lane)
    lanes.velocity.set(
        lane, lanes.velocity[lane] + (0.5 * time_step / body.mass(lane)) * (lanes.force[lane] + force[lane]));
}

/// Total force on grains: contacts, air, weight; `power` of the air.
template <class Bodies>
void total_force(const GrainLanes& lanes, Vectors& force, const Bodies& bodies, double time_step,
                 Scalars& power) {
  const std::size_t groups = lanes.groups();
  const auto& body = bodies.kept();
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < groups; ++lane) {
    const Vector3 predicted = lanes.velocity[lane] + (time_step / body.mass(lane)) * lanes.force[lane];
    const Vector3 air = (-body.drag(lane)) * predicted;
    power[lane] = dot(air, predicted);
    force.set(lane, force[lane] + air + body.weight(lane));
  }
}

/// Spins from contact moments (laboratory frame) and air; `moment` becomes the torque in
/// the body frame, `power` that of the air.
template <class Bodies>
void kick_spin(GrainLanes& lanes, Vectors& moment, const Bodies& bodies, double time_step, Scalars& power) {
  const std::size_t groups = lanes.groups();
  const auto& body = bodies.kept();
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < groups; ++lane) {
    const Vector3 inertia = body.inertia(lane), drag = body.turning_drag(lane);
    const Rotation rotation = rotation_of(lanes.orientation[lane]);
    const Vector3 spin = lanes.spin[lane];
    // The same prediction as before the end of the step: the torque is still that at its start.
    const Vector3 predicted = spin + time_step * spin_rate(inertia, spin, lanes.torque[lane]);
    const Vector3 air{-drag.x * predicted.x, -drag.y * predicted.y, -drag.z * predicted.z};
    power[lane] += dot(air, predicted);
    const Vector3 torque = rotation.back(moment[lane]) + air;
    lanes.spin.set(lane, advance_spin(inertia, spin, lanes.torque[lane], torque, time_step));
    moment.set(lane, torque);
  }
}

}  // namespace

/// Grains of one type: the same in all lanes.
struct GrainIntegrator::EqualBodies {
  double mass_, drag_;
  Vector3 inertia_, weight_, turning_drag_;

  explicit EqualBodies(const Body& body)
      : mass_(body.mass),
        drag_(body.drag),
        inertia_(body.inertia),
        weight_(body.weight),
        turning_drag_(body.turning_drag) {}
  void load(const std::vector<Body>&, const Grains&, const GrainLanes&) {}
  /// A copy, so that loops can keep the numbers in registers.
  EqualBodies kept() const { return *this; }
  double mass(std::size_t) const { return mass_; }
  double drag(std::size_t) const { return drag_; }
  Vector3 inertia(std::size_t) const { return inertia_; }
  Vector3 weight(std::size_t) const { return weight_; }
  Vector3 turning_drag(std::size_t) const { return turning_drag_; }
};

/// Grains of several types: one set of constants per lane.
struct GrainIntegrator::BodyLanes {
  Scalars mass_, drag_;
  Vectors inertia_, weight_, turning_drag_;

  void load(const std::vector<Body>& bodies, const Grains& grains, const GrainLanes& lanes) {
    for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
      const Body& body = bodies[grains.kind[lanes.grain(lane)]];
      mass_[lane] = body.mass;
      drag_[lane] = body.drag;
      inertia_.set(lane, body.inertia);
      weight_.set(lane, body.weight);
      turning_drag_.set(lane, body.turning_drag);
    }
  }
  const BodyLanes& kept() const { return *this; }
  double mass(std::size_t lane) const { return mass_[lane]; }
  double drag(std::size_t lane) const { return drag_[lane]; }
  Vector3 inertia(std::size_t lane) const { return inertia_[lane]; }
  Vector3 weight(std::size_t lane) const { return weight_[lane]; }
  Vector3 turning_drag(std::size_t lane) const { return turning_drag_[lane]; }
};

GrainIntegrator::GrainIntegrator(const ParticleTypes& types, const Eigen::Vector3d& gravity,
                                 double air_viscosity, bool rolls, double time_step,
                                 InstructionSet instructions)
    : rotates_(types.rotates()),
      displacement_per_turn_(types.displacement_per_turn()),
      time_step_(time_step),
      instructions_(instructions) {
  for (std::size_t k = 0; k < types.size(); ++k)
    bodies_.push_back(body_of(types.shape(static_cast<TypeNumber>(k)), gravity, air_viscosity));
  if (types.clumps()) return;
  std::vector<SphereIntegrator::Body> spheres;
  for (const Body& body : bodies_) spheres.push_back({body.mass, body.drag, body.inertia.x, body.weight});
  single_.emplace(std::move(spheres), rotates_, rolls, time_step, instructions);
}

GrainIntegrator::Body GrainIntegrator::body_of(const GrainShape& shape, const Eigen::Vector3d& gravity,
                                               double air_viscosity) {
  const double drag_over_radius = 6 * std::numbers::pi * air_viscosity;
  double radii = 0;                                   // m, of all spheres
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  // m^3, sum over spheres of R (b^2 - b_a^2)
  for (std::size_t k = 0; k < shape.spheres(); ++k) {
    const Eigen::Vector3d& offset = shape.sphere_offsets[k];
    radii += shape.radius_of(k);
    squares += shape.radius_of(k) * (Eigen::Vector3d::Constant(offset.squaredNorm()) - offset.cwiseAbs2());
  }
  return {shape.mass, drag_over_radius * radii, plain(shape.inertia),
          plain(Eigen::Vector3d(shape.mass * gravity)), drag_over_radius * plain(squares)};
}

double GrainIntegrator::advance(Grains& grains, std::size_t begin, std::size_t end, const Vector3& drifted,
                                SphereField& spheres) const {
  if (single_) return single_->advance(grains, begin, end, drifted);
  if (bodies_.size() == 1) {
    EqualBodies bodies(bodies_.front());
    return advance_with(bodies, grains, begin, end, drifted, spheres);
  }
  BodyLanes bodies;
  return advance_with(bodies, grains, begin, end, drifted, spheres);
}

template <class Bodies>
double GrainIntegrator::advance_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                                     const Vector3& drifted, SphereField& spheres) const {
  GrainLanes lanes;
  Advanced out;
  LaneMax farthest;
  for (std::size_t first = begin; first < end; first += kGrains) {
    lanes.load(grains, first, end, rotates_);
    lanes.load_positions(grains);
    bodies.load(bodies_, grains, lanes);
    with_instructions(instructions_, [&] { drift(lanes, out, bodies, time_step_, drifted); });
    if (rotates_)
      with_instructions(instructions_, [&] { turn(lanes, out, bodies, time_step_, displacement_per_turn_); });
    farthest.add(out.way, lanes.count);

    for (std::size_t lane = 0; lane < lanes.count; ++lane) {
      const std::size_t k = first + lane;
      grains.position[k] = eigen(lanes.position[lane]);
      if (rotates_) grains.orientation[k] = eigen(lanes.orientation[lane]);
      spheres.set_motion(k, {out.velocity[lane], rotates_ ? out.spin[lane] : Vector3{}});
    }
  }
  return farthest.max();
}

StepWork GrainIntegrator::finish(Grains& grains, std::size_t begin, std::size_t end,
                                 const ContactSums& contacts, std::size_t first_sum) const {
  if (single_) return single_->finish(grains, begin, end, contacts, first_sum);
  if (bodies_.size() == 1) {
    EqualBodies bodies(bodies_.front());
    return finish_with(bodies, grains, begin, end, contacts, first_sum);
  }
  BodyLanes bodies;
  return finish_with(bodies, grains, begin, end, contacts, first_sum);
}

template <class Bodies>
StepWork GrainIntegrator::finish_with(Bodies& bodies, Grains& grains, std::size_t begin, std::size_t end,
                                      const ContactSums& contacts, std::size_t first_sum) const {
  GrainLanes lanes;
  Vectors force, moment;
  Scalars drag_power;
  LaneSum drag_sum;
  for (std::size_t first = begin; first < end; first += kGrains) {
    lanes.load(grains, first, end, rotates_);
    bodies.load(bodies_, grains, lanes);
    for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
      const std::size_t sum = first_sum + lanes.grain(lane) - begin;
      force.set(lane, contacts.force(sum));
      moment.set(lane, contacts.moment(sum));
    }
    with_instructions(instructions_, [&] {
      total_force(lanes, force, bodies, time_step_, drag_power);
      kick(lanes, force, bodies, time_step_);
    });
    if (rotates_)
      with_instructions(instructions_, [&] { kick_spin(lanes, moment, bodies, time_step_, drag_power); });
    drag_sum.add(drag_power, lanes.count);
    for (std::size_t lane = 0; lane < lanes.count; ++lane) {
      const std::size_t k = first + lane;
      grains.velocity[k] = eigen(lanes.velocity[lane]);
      grains.force[k] = eigen(force[lane]);
      if (!rotates_) continue;
      grains.spin[k] = eigen(lanes.spin[lane]);
      grains.torque[k] = eigen(moment[lane]);
    }
  }
  return {drag_sum.total() * time_step_, 0};
}

}  // namespace diefill::engine
