// A wall body that moves by the forces on it instead of along a prescribed path: a ball that falls into
// powder, a punch or gate on a guide. It has mass and moments of inertia; its motion is part of the
// simulation's state.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "engine/powder/grains.h"
#include "engine/walls/walls.h"

namespace diefill::engine {

/// A rigid plane that the body's centre of mass does not pass: where its way since the release along
/// `direction` is `distance`. Its velocity along `direction` is then thrown back, times `restitution`.
struct TravelStop {
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  ///< unit vector, laboratory frame
  double distance = 0;                                    ///< m
  double restitution = 0;                                 ///< 0 to 1
};

/// What a free body is and how it starts. SI units.
struct FreeBodySpec {
  static constexpr std::size_t kMaxStops = 6;

  std::size_t body = 0;                                ///< number of the wall body
  double mass = 0;                                     ///< kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< m, of mass, body frame
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< kg m^2, about the centre, body frame
  Eigen::Vector3d guide = Eigen::Vector3d::Zero();     ///< unit vector: moves along it only; zero: no guide
  bool turns = true;                                   ///< false: keeps its orientation
  Eigen::Vector3d drive = Eigen::Vector3d::Zero();     ///< N, constant force beside weight and contacts
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, of the centre at the release
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame, at the release
  std::array<TravelStop, kMaxStops> stops;
  std::size_t stop_count = 0;
};

/// State of a free body. A plain value: all that a restart needs.
struct FreeBody {
  FreeBodySpec spec;
  Eigen::Vector3d principal_inertia = Eigen::Vector3d::Ones();   ///< kg m^2
  Eigen::Matrix3d principal_axes = Eigen::Matrix3d::Identity();  ///< columns, body frame, right-handed
  Eigen::Vector3d start = Eigen::Vector3d::Zero();               ///< m, centre at the release
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< m, centre
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();            ///< m/s, of the centre
  Quaternion orientation = {1, 0, 0, 0};             ///< (w, x, y, z), principal axes to laboratory
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();    ///< rad/s, about the principal axes
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N, of the powder in the last step
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< N m, about the centre, principal axes
  bool held = false;                                 ///< stands still where it is

  /// J, of translation and rotation.
  double kinetic_energy() const;
};

/// Powder's force (N) and torque (N m, about the origin of the body's frame) on the body, as of now.
struct BodyLoad {
  Eigen::Vector3d force, torque;
};

/// The body where `pose` has it, under `load`. Throws std::invalid_argument for a mass or moments of inertia
/// that are not positive, a guide or stop without a unit direction.
FreeBody released(const FreeBodySpec& spec, const BodyMotion& pose, const BodyLoad& load);

/// First half of a velocity Verlet step (Bierwisch 2009, Eqs. 2.18 to 2.24): place and orientation at its
/// end. Returns the pose there, with predicted velocities.
BodyMotion advance(FreeBody& body, const Eigen::Vector3d& gravity, double time_step);

/// Second half (Eq. 2.25): velocities, from the load at the end of the step in the pose `now`; then the
/// stops. Returns the pose with these velocities.
BodyMotion finish(FreeBody& body, const BodyMotion& now, const BodyLoad& load, const Eigen::Vector3d& gravity,
                  double time_step);

/// Where it is and how it moves.
BodyMotion pose_of(const FreeBody& body);

}  // namespace diefill::engine
