#include "engine/grain_integrator.h"

#include <algorithm>
#include <numbers>

#include "engine/lanes.h"
#include "engine/rigid_motion.h"

namespace diefill::engine {

namespace {

constexpr std::size_t kGrains = 16;  ///< grains worked on at a time
using Scalars = Lanes<kGrains>;
using Vectors = VectorLanes<kGrains>;

/// One quaternion a lane.
struct QuaternionLanes {
  Scalars w, x, y, z;
  PlainQuaternion operator[](std::size_t lane) const { return {w[lane], x[lane], y[lane], z[lane]}; }
  void set(std::size_t lane, PlainQuaternion q) {
    w[lane] = q.w;
    x[lane] = q.x;
    y[lane] = q.y;
    z[lane] = q.z;
  }
};

/// A few grains, one lane each; lanes beyond `count` repeat the last grain.
struct GrainLanes {
  std::size_t begin = 0, count = 0;
  Vectors position, velocity, force, spin, torque;
  QuaternionLanes orientation;

  std::size_t groups() const { return whole_groups(count); }
  /// The grain of a lane.
  std::size_t grain(std::size_t lane) const { return begin + std::min(lane, count - 1); }

  void load(const Grains& grains, std::size_t first, std::size_t end, const GrainShape& shape) {
    begin = first;
    count = std::min(kGrains, end - first);
    for (std::size_t lane = 0; lane < groups(); ++lane) {
      const std::size_t k = grain(lane);
      velocity.set(lane, plain(grains.velocity[k]));
      force.set(lane, plain(grains.force[k]));
      if (!shape.rotates) continue;
      spin.set(lane, plain(grains.spin[k]));
      torque.set(lane, plain(grains.torque[k]));
      if (shape.spheres() > 1) orientation.set(lane, plain(grains.orientation[k]));
    }
  }
  /// Positions are needed on the way to the end of the step only.
  void load_positions(const Grains& grains) {
    for (std::size_t lane = 0; lane < groups(); ++lane)
      position.set(lane, plain(grains.position[grain(lane)]));
  }
};

/// Where advanced grains and their spheres are, and how they move.
struct Advanced {
  Vectors velocity, spin;  ///< predicted; spin in the laboratory frame
  Vectors row_x, row_y, row_z;

  Rotation rotation(std::size_t lane) const { return {row_x[lane], row_y[lane], row_z[lane]}; }
};

/// Positions and predicted velocities at the end of the step.
void drift(GrainLanes& lanes, Advanced& out, double mass, double time_step) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Vector3 acceleration = (1 / mass) * lanes.force[lane];
    lanes.position.set(lane, lanes.position[lane] + time_step * lanes.velocity[lane] +
                                 (0.5 * time_step * time_step) * acceleration);
    out.velocity.set(lane, lanes.velocity[lane] + time_step * acceleration);
  }
}

/// Orientations and predicted spins at the end of the step.
void turn(GrainLanes& lanes, Advanced& out, Vector3 inertia, double time_step) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Vector3 rate = spin_rate(inertia, lanes.spin[lane], lanes.torque[lane]);
    const PlainQuaternion orientation =
        advance_orientation(lanes.orientation[lane], lanes.spin[lane], rate, time_step);
    const Rotation rotation = rotation_of(orientation);
    lanes.orientation.set(lane, orientation);
    out.spin.set(lane, rotation * (lanes.spin[lane] + time_step * rate));
    out.row_x.set(lane, rotation.row_x);
    out.row_y.set(lane, rotation.row_y);
    out.row_z.set(lane, rotation.row_z);
  }
}

/// The same for single spheres, which have no orientation worth following.
void turn_sphere(const GrainLanes& lanes, Advanced& out, Vector3 inertia, double time_step) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane)
    out.spin.set(lane,
                 lanes.spin[lane] + time_step * spin_rate(inertia, lanes.spin[lane], lanes.torque[lane]));
}

/// Sphere `offset` (m, body frame) of each grain.
void place_sphere(const GrainLanes& lanes, const Advanced& grain, Vector3 offset, Vectors& position,
                  Vectors& velocity) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Vector3 arm = grain.rotation(lane) * offset;
    position.set(lane, lanes.position[lane] + arm);
    velocity.set(lane, grain.velocity[lane] + cross(grain.spin[lane], arm));
  }
}

/// New velocities from the forces before and after the step.
void kick(GrainLanes& lanes, const Vectors& force, double mass, double time_step) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane)
    lanes.velocity.set(lane,
                       lanes.velocity[lane] + (0.5 * time_step / mass) * (lanes.force[lane] + force[lane]));
}

/// Total force on grains: contacts, air, weight; `power` of the air.
void total_force(const GrainLanes& lanes, Vectors& force, double drag, Vector3 weight, double mass,
                 double time_step, Scalars& power) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Vector3 predicted = lanes.velocity[lane] + (time_step / mass) * lanes.force[lane];
    const Vector3 air = (-drag) * predicted;
    power[lane] = dot(air, predicted);
    force.set(lane, force[lane] + air + weight);
  }
}

/// Spins of composed grains from contact moments (laboratory frame) and air; `moment` becomes the torque in
/// the body frame, `power` that of the air.
void kick_spin(GrainLanes& lanes, Vectors& moment, Vector3 inertia, Vector3 drag, double time_step,
               Scalars& power) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Rotation rotation = rotation_of(lanes.orientation[lane]);
    const Vector3 spin = lanes.spin[lane];
    // The same prediction as before the step's end: torque is still the one that it began with.
    const Vector3 predicted = spin + time_step * spin_rate(inertia, spin, lanes.torque[lane]);
    const Vector3 air{-drag.x * predicted.x, -drag.y * predicted.y, -drag.z * predicted.z};
    power[lane] += dot(air, predicted);
    const Vector3 torque = rotation.back(moment[lane]) + air;
    lanes.spin.set(lane, advance_spin(inertia, spin, lanes.torque[lane], torque, time_step));
    moment.set(lane, torque);
  }
}

/// Spins of single spheres, slowed by rolling friction (Bierwisch 2009, Eq. 2.11), which stops a rotation but
/// never reverses it within a step (OP-9); `power` is that of rolling friction.
void kick_sphere_spin(GrainLanes& lanes, const Vectors& moment, const Scalars& rolling_load, Vector3 inertia,
                      double time_step, Scalars& power) {
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
    const Vector3 spin = advance_spin(inertia, lanes.spin[lane], lanes.torque[lane], moment[lane], time_step);
    const double speed = length(spin);
    const double slower = std::max(0.0, speed - rolling_load[lane] * time_step / inertia.x);
    power[lane] = 0.5 * inertia.x * (slower * slower - speed * speed) / time_step;
    lanes.spin.set(lane, (speed > 0 ? slower / speed : 1.0) * spin);
  }
}

}  // namespace

GrainIntegrator::GrainIntegrator(const GrainShape& shape, const Eigen::Vector3d& gravity,
                                 double air_viscosity, double time_step, InstructionSet instructions)
    : shape_(shape),
      inertia_(plain(shape.inertia)),
      weight_(plain(Eigen::Vector3d(shape.mass * gravity))),
      sphere_drag_(6 * std::numbers::pi * air_viscosity * shape.sphere_radius),
      time_step_(time_step),
      instructions_(instructions) {
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  for (const auto& offset : shape.sphere_offsets)
    squares += Eigen::Vector3d::Constant(offset.squaredNorm()) - offset.cwiseAbs2();
  drag_inertia_ = plain(squares);
}

void GrainIntegrator::advance(Grains& grains, std::size_t begin, std::size_t end,
                              SphereField& spheres) const {
  const std::size_t per_grain = shape_.spheres();
  thread_local GrainLanes lanes;
  thread_local Advanced out;
  thread_local Vectors position, velocity;
  for (std::size_t first = begin; first < end; first += kGrains) {
    lanes.load(grains, first, end, shape_);
    lanes.load_positions(grains);
    with_instructions(instructions_, [&] { drift(lanes, out, shape_.mass, time_step_); });
    if (shape_.rotates && per_grain > 1)
      with_instructions(instructions_, [&] { turn(lanes, out, inertia_, time_step_); });
    else if (shape_.rotates)
      with_instructions(instructions_, [&] { turn_sphere(lanes, out, inertia_, time_step_); });

    for (std::size_t lane = 0; lane < lanes.count; ++lane) {
      const std::size_t k = first + lane;
      grains.position[k] = eigen(lanes.position[lane]);
      if (per_grain > 1) {
        grains.orientation[k] = eigen(lanes.orientation[lane]);
      } else {
        spheres.position[k] = lanes.position[lane];
        spheres.motion[k] = {out.velocity[lane], shape_.rotates ? out.spin[lane] : Vector3{}};
      }
    }
    if (per_grain == 1) continue;
    for (std::size_t s = 0; s < per_grain; ++s) {
      const Vector3 offset = plain(shape_.sphere_offsets[s]);
      with_instructions(instructions_, [&] { place_sphere(lanes, out, offset, position, velocity); });
      for (std::size_t lane = 0; lane < lanes.count; ++lane) {
        spheres.position[(first + lane) * per_grain + s] = position[lane];
        spheres.motion[(first + lane) * per_grain + s] = {velocity[lane], out.spin[lane]};
      }
    }
  }
}

GrainIntegrator::Work GrainIntegrator::finish(Grains& grains, std::size_t begin, std::size_t end,
                                              std::span<const ContactSum> contacts) const {
  const bool composed = shape_.spheres() > 1;
  const double drag = sphere_drag_ * static_cast<double>(shape_.spheres());
  const Vector3 turning_drag = sphere_drag_ * drag_inertia_;
  thread_local GrainLanes lanes;
  thread_local Vectors force, moment;
  thread_local Scalars rolling_load, drag_power, rolling_power;
  LaneSum drag_sum, rolling_sum;
  for (std::size_t first = begin; first < end; first += kGrains) {
    lanes.load(grains, first, end, shape_);
    for (std::size_t lane = 0; lane < lanes.groups(); ++lane) {
      const ContactSum& sum = contacts[lanes.grain(lane) - begin];
      force.set(lane, sum.force());
      moment.set(lane, sum.moment());
      rolling_load[lane] = sum.rolling_load();
    }
    with_instructions(instructions_, [&] {
      total_force(lanes, force, drag, weight_, shape_.mass, time_step_, drag_power);
      kick(lanes, force, shape_.mass, time_step_);
    });
    if (composed && shape_.rotates)
      with_instructions(instructions_,
                        [&] { kick_spin(lanes, moment, inertia_, turning_drag, time_step_, drag_power); });
    else if (shape_.rotates) {
      with_instructions(instructions_, [&] {
        kick_sphere_spin(lanes, moment, rolling_load, inertia_, time_step_, rolling_power);
      });
      rolling_sum.add(rolling_power, lanes.count);
    }
    drag_sum.add(drag_power, lanes.count);
    for (std::size_t lane = 0; lane < lanes.count; ++lane) {
      const std::size_t k = first + lane;
      grains.velocity[k] = eigen(lanes.velocity[lane]);
      grains.force[k] = eigen(force[lane]);
      if (!shape_.rotates) continue;
      grains.spin[k] = eigen(lanes.spin[lane]);
      grains.torque[k] = eigen(moment[lane]);
    }
  }
  return {drag_sum.total() * time_step_, rolling_sum.total() * time_step_};
}

}  // namespace diefill::engine
