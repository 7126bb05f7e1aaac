// Solids in a fluid of particles: rigid sets of such particles. Grains move by the forces on them, tools by
// a prescribed motion. Each particle is a particle of the simulation in its own right, so that a set of
// hundreds does not reserve memory for as many in every grain.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/fluid/sheared_period.h"
#include "engine/powder/grain_shape.h"
#include "engine/powder/grains.h"

namespace diefill::engine {

/// A solid to be added. SI units.
struct RigidSetSpec {
  GrainShape shape;                                            ///< its sphere centres are the particles
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();            ///< m, of mass
  Quaternion orientation = {1, 0, 0, 0};                       ///< body to laboratory
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s; kept along axes that are not free
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, body frame
  Eigen::Vector3d drive = Eigen::Vector3d::Zero();             ///< N, constant force beside that of particles
  std::array<bool, 3> free = {true, true, true};               ///< along x, y, z: moves by forces
  bool turns = true;                                           ///< by torques
  bool tool = false;                                           ///< tools do not act on each other
};

/// The state of a moving solid. A plain value: all that a restart needs besides its RigidSetSpec.
struct RigidSetMotion {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< m, not put back into a periodic box
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s; within a step the predicted one
  Quaternion orientation = {1, 0, 0, 0};               ///< body to laboratory
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< rad/s, body frame
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     ///< N, of particles and drive, at the last step
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();    ///< N m, about the centre, body frame
};

/// All solids of a simulation. Particles are named by their persistent numbers (Grains::id).
class RigidSets {
 public:
  static constexpr std::uint32_t kFluid = std::numeric_limits<std::uint32_t>::max();

  /// Particles from here on are the fluid's, `count` of them.
  void add_fluid(std::size_t count) { set_of_.insert(set_of_.end(), count, kFluid); }
  /// The next shape.spheres() particles are the set's. Throws std::invalid_argument for one without mass, or
  /// without moments of inertia where it turns.
  void add(const RigidSetSpec& spec);

  bool any() const { return !specs_.empty(); }
  std::size_t size() const { return specs_.size(); }
  const RigidSetSpec& spec(std::size_t s) const { return specs_[s]; }
  const std::vector<RigidSetMotion>& motion() const { return motion_; }
  void restore(const std::vector<RigidSetMotion>& motion);
  /// Number of the set of a particle, or kFluid.
  std::uint32_t set_of(std::uint64_t particle) const { return set_of_[particle]; }
  bool is_tool(std::uint32_t set) const { return specs_[set].tool; }
  /// m, laboratory frame, from the centre of its set to a particle.
  Eigen::Vector3d arm(std::uint64_t particle) const;
  /// The set's new force along each axis beside that of particles (N).
  void set_drive(std::size_t s, const Eigen::Vector3d& drive) { specs_[s].drive = drive; }
  /// The set's velocity (m/s) along axes that are not free.
  void set_velocity(std::size_t s, const Eigen::Vector3d& velocity);

  /// First half of a step of velocity Verlet (Bierwisch 2009, Eqs. 2.18 to 2.24): places at its end, with
  /// predicted velocities.
  void advance(double time_step);
  /// The particle's place and velocity as its set has them, where the period brings it nearest to `grains`'
  /// present one.
  void place(std::size_t k, Grains& grains, const ShearedPeriod& period, double time) const;
  /// Second half (Eq. 2.25): velocities by the forces on the particles at the end of the step.
  void finish(const Grains& grains, double time_step);

 private:
  void turn_frames();
  void turn_spins();

  std::vector<RigidSetSpec> specs_;
  std::vector<RigidSetMotion> motion_;
  std::vector<Eigen::Matrix3d> frame_;  ///< of each set, body to laboratory, as of now
  std::vector<Eigen::Vector3d> spin_;   ///< rad/s, laboratory frame; within a step the predicted ones
  std::vector<std::uint64_t> first_;    ///< first particle of each set
  std::vector<std::uint32_t> set_of_;
};

}  // namespace diefill::engine
