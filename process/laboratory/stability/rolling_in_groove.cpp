#include "process/laboratory/stability/rolling_in_groove.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "engine/powder/sphere_volume.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/standard_gravity.h"

namespace diefill::process::laboratory {

namespace {

namespace laws = engine::laws;

constexpr double kGravity = engine::kStandardGravity, kStiffness = 1e4, kShearStiffness = 8235;  // m/s^2, N/m
constexpr double kRestitution = 0.5, kFriction = 0.5;

double large_radius(const GrooveCase& groove) {
  return groove.ratio * kFineRadius;
}

double fine_mass() {
  return engine::sphere_mass(kFineDensity, kFineRadius);
}

/// m, of the fine centre from the line through the large ones, just in touch.
double way_round(const GrooveCase& groove) {
  const double large = large_radius(groove), reach = large + kFineRadius;
  return std::sqrt(reach * reach - large * large);
}

/// m: overlaps that carry the weight at the start.
Eigen::Vector3d start_of(const GrooveCase& groove) {
  const double reach = large_radius(groove) + kFineRadius;
  const double load = fine_mass() * kGravity * reach / (2 * way_round(groove));
  const double height = way_round(groove) * (1 - load / kStiffness * reach / std::pow(way_round(groove), 2));
  return {0, height * std::sin(groove.start), height * std::cos(groove.start)};
}

GroovePlace seen_along_groove(const GrooveCase& groove, const Eigen::Vector3d& place) {
  return {std::atan2(place.y(), place.z()), std::hypot(place.y(), place.z()) / way_round(groove)};
}

/// The fine sphere on its own, with the laws called one by one.
class HalfStepSphere {
 public:
  explicit HalfStepSphere(const GrooveCase& groove)
      : large_(large_radius(groove)),
        place_(start_of(groove)),
        pair_{kFineRadius, large_, fine_mass(), std::numeric_limits<double>::infinity()},
        damping_({kRestitution, kStiffness}, pair_),
        friction_({kShearStiffness, 0, kFriction, kFriction}, pair_) {}

  void step(double time_step) {
    kick(0.5 * time_step);
    place_ += time_step * velocity_;
    find_forces(time_step);
    kick(0.5 * time_step);
  }
  const Eigen::Vector3d& place() const { return place_; }

 private:
  void kick(double time) {
    velocity_ += time / fine_mass() * force_;
    spin_ += time / (0.4 * fine_mass() * kFineRadius * kFineRadius) * torque_;
  }

  void find_forces(double time_step) {
    force_ = {0, 0, -fine_mass() * kGravity};
    torque_.setZero();
    for (int side = 0; side < 2; ++side) {
      const Eigen::Vector3d apart = place_ - Eigen::Vector3d(side == 0 ? large_ : -large_, 0, 0);
      const double overlap = kFineRadius + large_ - apart.norm();
      double* history = history_[side];
      if (!(overlap > 0)) {
        std::fill_n(history, laws::LudingFriction::kHistory, 0.0);
        continue;
      }
      const Eigen::Vector3d normal = apart.normalized();
      const double speed = velocity_.dot(normal);
      const Eigen::Vector3d sliding = velocity_ - speed * normal - kFineRadius * spin_.cross(normal);
      const double push = kStiffness * overlap + damping_.force(overlap, std::sqrt(overlap), speed);
      const Eigen::Vector3d drag =
          engine::eigen(friction_.force(history, engine::plain(normal), engine::plain(sliding),
                                        std::sqrt(overlap), std::abs(push), time_step));
      force_ += push * normal + drag;
      torque_ += (-kFineRadius * normal).cross(drag);
    }
  }

  double large_;
  Eigen::Vector3d place_, velocity_ = Eigen::Vector3d::Zero(), spin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), torque_ = Eigen::Vector3d::Zero();
  laws::PairProperties pair_;
  laws::LinearRestitutionDamping damping_;
  laws::LudingFriction friction_;
  double history_[2][laws::LudingFriction::kHistory] = {};
};

}  // namespace

laws::LawParameters groove_law() {
  laws::LawParameters law;
  law.normal = laws::LinearNormal::Parameters{kStiffness};
  law.damping = laws::LinearRestitutionDamping::Parameters{kRestitution, kStiffness};
  law.friction = laws::LudingFriction::Parameters{kShearStiffness, 0, kFriction, kFriction};
  return law;
}

double rolling_time(const GrooveCase& groove, double angle) {
  const double reach = large_radius(groove) + kFineRadius, round = way_round(groove);
  const double slowness = 1 + 0.4 * reach * reach / (round * round);
  // sin(phi / 2) = sin(phi_0 / 2) cosh w takes the pole at the start out of the pendulum's integral.
  const double low = std::sin(0.5 * groove.start);
  const double end = std::acosh(std::sin(0.5 * angle) / low);
  constexpr int kParts = 2000;
  double sum = 0;
  for (int k = 0; k < kParts; ++k) {
    const double rise = low * std::cosh((k + 0.5) * end / kParts);
    sum += end / kParts / std::sqrt(1 - rise * rise);
  }
  return std::sqrt(round * slowness / kGravity) * sum;
}

GroovePlace place_by_engine(const GrooveCase& groove, double time, double time_step) {
  engine::SimulationSettings settings;
  settings.types = {{engine::model_b(kFineRadius, fine_mass())}};
  settings.gravity = {0, 0, -kGravity};
  settings.time_step = time_step;
  settings.contact = engine::one_powder(groove_law(), groove_law());
  engine::WallBodySpec large;
  large.name = "large spheres";
  large.sphere_radius = large_radius(groove);
  large.centres = {{large.sphere_radius, 0, 0}, {-large.sphere_radius, 0, 0}};
  engine::Simulation simulation(settings, {large});
  engine::NewGrain fine;
  fine.position = start_of(groove);
  simulation.add_grains({fine});
  for (long k = std::lround(time / time_step); k > 0; --k) simulation.step();
  return seen_along_groove(groove, simulation.grains().position[0]);
}

GroovePlace place_by_half_steps(const GrooveCase& groove, double time, double time_step) {
  HalfStepSphere fine(groove);
  for (long k = std::lround(time / time_step); k > 0; --k) fine.step(time_step);
  return seen_along_groove(groove, fine.place());
}

}  // namespace diefill::process::laboratory
