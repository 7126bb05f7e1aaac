// The same physics as the engine, written once more as plainly as can be: every pair of spheres in every
// step, one after the other, in the thesis' own notation. Slow, and obvious enough to be the judge.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include "engine/simulation/simulation.h"
#include "tests/engine/thesis_rotation.h"
#include "tests/support/contact_access.h"

namespace diefill::engine {

/// Grains of several kinds: shapes, and contacts between kinds and of kinds with walls.
struct ReferenceKinds {
  std::vector<GrainShape> shapes;
  std::function<ContactParameters(std::size_t, std::size_t)> grain_contact;
  std::function<ContactParameters(std::size_t)> wall_contact;
};

struct ReferenceGrain {
  std::size_t kind;
  Eigen::Vector3d position, velocity;                       // m, m/s
  ThesisQuaternion orientation;                             // (xi, eta, zeta, chi)
  Eigen::Matrix3d to_lab;                                   // A^T of the orientation
  Eigen::Vector3d spin;                                     // rad/s, body frame
  Eigen::Vector3d force, torque = Eigen::Vector3d::Zero();  // N; N m in the body frame
  Eigen::Vector3d predicted_velocity, predicted_angular;    // m/s; rad/s, laboratory frame
  Eigen::Vector3d new_force, new_torque;                    // laboratory frame
  double rolling_load = 0;                                  // N m
};

class ReferenceDem {
 public:
  ReferenceDem(const SimulationSettings& settings, std::vector<WallBodySpec> walls)
      : ReferenceDem(settings, std::move(walls),
                     {{settings.shape()},
                      [contact = grain_contact(settings)](std::size_t, std::size_t) { return contact; },
                      [contact = wall_contact(settings)](std::size_t) { return contact; }}) {}
  ReferenceDem(const SimulationSettings& settings, std::vector<WallBodySpec> walls, ReferenceKinds kinds)
      : settings_(settings), walls_(std::move(walls)), types_(std::move(kinds)) {}

  void add(const NewGrain& added) {
    ReferenceGrain grain;
    grain.kind = added.kind;
    grain.position = added.position;
    grain.velocity = added.velocity;
    grain.orientation = single() ? ThesisQuaternion(0, 0, 0, 1) : to_thesis(added.orientation.normalized());
    grain.to_lab = thesis_matrix(grain.orientation).transpose();
    grain.spin = grain.to_lab.transpose() * added.angular_velocity;
    grain.force = shape(grain).mass * settings_.gravity;
    grains_.push_back(grain);
  }

  void step() {
    ++steps_;
    for (auto& grain : grains_) advance(grain);
    for (auto& grain : grains_) start_forces(grain);
    for (std::size_t a = 0; a < grains_.size(); ++a)
      for (std::size_t b = a + 1; b < grains_.size(); ++b) touch_grains(a, b);
    for (std::size_t a = 0; a < grains_.size(); ++a)
      for (std::size_t body = 0; body < walls_.size(); ++body) touch_body(a, body);
    for (auto& grain : grains_) finish(grain);
  }

  const std::vector<ReferenceGrain>& grains() const { return grains_; }

 private:
  using Key = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, bool>;

  const GrainShape& shape(const ReferenceGrain& grain) const { return types_.shapes[grain.kind]; }
  bool single() const { return types_.shapes.front().sphere_offsets.size() == 1; }
  bool rotates() const { return types_.shapes.front().rotates; }
  double dt() const { return settings_.time_step; }

  static Eigen::Vector3d spin_rate_of(const Eigen::Vector3d& moment, const Eigen::Vector3d& spin,
                                      const Eigen::Vector3d& torque) {
    Eigen::Vector3d rate;
    for (int a = 0; a < 3; ++a) {  // Eq. 2.24
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      rate[a] = (torque[a] + (moment[b] - moment[c]) * spin[b] * spin[c]) / moment[a];
    }
    return rate;
  }

  void advance(ReferenceGrain& grain) const {
    const Eigen::Vector3d acceleration = grain.force / shape(grain).mass;
    grain.position += grain.velocity * dt() + 0.5 * acceleration * dt() * dt();
    grain.predicted_velocity = grain.velocity + acceleration * dt();
    grain.predicted_angular.setZero();
    if (!rotates()) return;
    const Eigen::Vector3d rate = spin_rate_of(shape(grain).inertia, grain.spin, grain.torque);
    if (!single()) turn(grain, rate);
    grain.to_lab = thesis_matrix(grain.orientation).transpose();
    grain.predicted_angular = grain.to_lab * (grain.spin + rate * dt());
  }

  // Eqs. 2.20 to 2.23.
  void turn(ReferenceGrain& grain, const Eigen::Vector3d& rate) const {
    ThesisQuaternion& q = grain.orientation;
    const double t = dt();
    const ThesisQuaternion first = 0.5 * thesis_rate_matrix(q) * grain.spin;
    const ThesisQuaternion second = 0.5 * thesis_rate_matrix(q) * rate - q * first.squaredNorm();
    const double fourth = first.squaredNorm() * first.squaredNorm();
    const double root = std::sqrt(1 - first.squaredNorm() * t * t - first.dot(second) * t * t * t -
                                  0.25 * (second.squaredNorm() - fourth) * t * t * t * t);
    const double lambda = (1 - 0.5 * first.squaredNorm() * t * t - root) / (t * t);
    q = (q + first * t + 0.5 * second * t * t - lambda * q * t * t).eval();
  }

  // Weight, and Stokes drag on every basic sphere at its centre (Eqs. 2.8, 2.9).
  void start_forces(ReferenceGrain& grain) const {
    grain.new_force = shape(grain).mass * settings_.gravity;
    grain.new_torque.setZero();
    grain.rolling_load = 0;
    for (const auto& offset : shape(grain).sphere_offsets) {
      const Eigen::Vector3d b = grain.to_lab * offset;
      const Eigen::Vector3d drag = -6 * std::numbers::pi * settings_.air_viscosity *
                                   shape(grain).sphere_radius *
                                   (grain.predicted_velocity + grain.predicted_angular.cross(b));
      grain.new_force += drag;
      grain.new_torque += b.cross(drag);
    }
  }

  Eigen::Vector3d sphere_arm(const ReferenceGrain& grain, std::size_t sphere) const {
    return grain.to_lab * shape(grain).sphere_offsets[sphere];
  }

  Eigen::Vector3d arm_at(double radius, const Eigen::Vector3d& b, const Eigen::Vector3d& outward,
                         double overlap) const {
    if (!rotates()) return Eigen::Vector3d::Zero();
    if (single()) return radius * outward;
    if (settings_.lever_arm == LeverArm::center) return b;
    return b + (radius - 0.5 * overlap) * outward;
  }

  // Force on i (Eqs. 2.3, 2.4, 2.6, 2.7; OP-1, OP-4). `load` receives |f_e + f_v|.
  Eigen::Vector3d law(const ContactParameters& p, double effective, double overlap,
                      const Eigen::Vector3d& normal, const Eigen::Vector3d& relative, Eigen::Vector3d& spring,
                      double& load) const {
    const double elastic = 2.0 / 3.0 * p.reduced_modulus * std::sqrt(effective) * std::pow(overlap, 1.5);
    const double cohesive = -std::sqrt(4 * std::numbers::pi * p.work_of_adhesion * p.reduced_modulus) *
                            std::pow(effective * overlap, 0.75);
    const double viscous = -p.damping * std::sqrt(effective * overlap) * relative.dot(normal);
    load = std::abs(elastic + viscous);
    const double length = spring.norm();
    Eigen::Vector3d flat = spring - spring.dot(normal) * normal;
    if (flat.norm() > 0) flat *= length / flat.norm();
    spring = flat + (relative - relative.dot(normal) * normal) * dt();
    const double pull = p.tangential * std::sqrt(overlap / effective) * spring.norm();
    Eigen::Vector3d tangential = Eigen::Vector3d::Zero();
    if (spring.norm() > 0) tangential = -std::min(pull, p.friction * load) * spring.normalized();
    if (spring_limit(settings_) == SpringLimit::cut_back && pull > p.friction * load)
      spring *= p.friction * load / pull;
    return (elastic + cohesive + viscous) * normal + tangential;
  }

  void touch_grains(std::size_t a, std::size_t b) {
    ReferenceGrain &i = grains_[a], &j = grains_[b];
    const double radius = shape(i).sphere_radius, other_radius = shape(j).sphere_radius;
    const double effective = radius * other_radius / (radius + other_radius);
    const ContactParameters contact = types_.grain_contact(i.kind, j.kind);
    for (std::size_t s = 0; s < shape(i).sphere_offsets.size(); ++s)
      for (std::size_t t = 0; t < shape(j).sphere_offsets.size(); ++t) {
        const Eigen::Vector3d bi = sphere_arm(i, s), bj = sphere_arm(j, t);
        const Eigen::Vector3d between = nearest(i.position + bi - j.position - bj);
        const double overlap = radius + other_radius - between.norm();
        const Key key{a, s, b, t, false};
        if (overlap <= 0) {
          springs_.erase(key);
          continue;
        }
        const Eigen::Vector3d normal = between.normalized();
        const Eigen::Vector3d arm_i = arm_at(radius, bi, -normal, overlap);
        const Eigen::Vector3d arm_j = arm_at(other_radius, bj, normal, overlap);
        const Eigen::Vector3d relative = i.predicted_velocity + i.predicted_angular.cross(arm_i) -
                                         j.predicted_velocity - j.predicted_angular.cross(arm_j);
        double load = 0;
        const Eigen::Vector3d force =
            law(contact, effective, overlap, normal, relative, spring_of(key), load);
        push(i, force, arm_i, contact.rolling_friction * load);
        push(j, -force, arm_j, contact.rolling_friction * load);
      }
  }

  void touch_body(std::size_t a, std::size_t body) {
    const auto& wall = walls_[body];
    const BodyMotion motion = wall.motion ? wall.motion(static_cast<double>(steps_) * dt()) : BodyMotion{};
    ReferenceGrain& i = grains_[a];
    const ContactParameters parameters = types_.wall_contact(i.kind);
    const double radius = shape(i).sphere_radius;
    const double effective = radius * wall.sphere_radius / (radius + wall.sphere_radius);
    for (std::size_t s = 0; s < shape(i).sphere_offsets.size(); ++s)
      for (std::size_t w = 0; w < wall.centres.size(); ++w) {
        const Eigen::Vector3d bi = sphere_arm(i, s);
        const Eigen::Vector3d between = i.position + bi - motion.point(wall.centres[w]);
        const double overlap = radius + wall.sphere_radius - between.norm();
        const Key key{a, s, body, w, true};
        if (overlap <= 0) {
          springs_.erase(key);
          continue;
        }
        const Eigen::Vector3d normal = between.normalized();
        const Eigen::Vector3d arm = arm_at(radius, bi, -normal, overlap);
        const Eigen::Vector3d contact = i.position + bi - (radius - 0.5 * overlap) * normal;
        const Eigen::Vector3d relative =
            i.predicted_velocity + i.predicted_angular.cross(arm) - motion.velocity_at(contact);
        double load = 0;
        const Eigen::Vector3d force =
            law(parameters, effective, overlap, normal, relative, spring_of(key), load);
        push(i, force, arm, parameters.rolling_friction * load);
      }
  }

  static void push(ReferenceGrain& grain, const Eigen::Vector3d& force, const Eigen::Vector3d& arm,
                   double rolling_load) {
    grain.new_force += force;
    grain.new_torque += arm.cross(force);
    grain.rolling_load += rolling_load;
  }

  Eigen::Vector3d& spring_of(const Key& key) {
    return springs_.try_emplace(key, Eigen::Vector3d::Zero()).first->second;
  }

  // The shortest of all periodic images of a distance.
  Eigen::Vector3d nearest(Eigen::Vector3d between) const {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (settings_.period[axis]) {
        double& x = between[static_cast<Eigen::Index>(axis)];
        x -= *settings_.period[axis] * std::round(x / *settings_.period[axis]);
      }
    return between;
  }

  void finish(ReferenceGrain& grain) const {
    grain.velocity += 0.5 * dt() / shape(grain).mass * (grain.force + grain.new_force);
    grain.force = grain.new_force;
    if (!rotates()) return;
    const Eigen::Vector3d torque = grain.to_lab.transpose() * grain.new_torque;
    const Eigen::Vector3d start = grain.spin, inertia = shape(grain).inertia;
    for (int iteration = 0; iteration < 3; ++iteration)  // Eq. 2.25
      grain.spin = start + 0.5 * dt() *
                               (spin_rate_of(inertia, start, grain.torque) +
                                spin_rate_of(inertia, grain.spin, torque));
    grain.torque = torque;
    if (!single() || grain.spin.norm() == 0) return;
    const double brake = grain.rolling_load * dt() / inertia[0];  // Eq. 2.11, OP-9
    grain.spin *= std::max(0.0, 1 - brake / grain.spin.norm());
  }

  SimulationSettings settings_;
  std::vector<WallBodySpec> walls_;
  ReferenceKinds types_;
  std::vector<ReferenceGrain> grains_;
  std::map<Key, Eigen::Vector3d> springs_;
  int steps_ = 0;
};

}  // namespace diefill::engine
