// A slow and obvious simulation of spheres: every pair in every step, one after the other, with any law that
// has react(). Made to be run beside the engine; shares nothing with it but the laws.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/laws/composed_law.h"

namespace diefill::engine::reference {

/// A rotating sphere. SI units, laboratory frame.
struct Ball {
  double radius = 0, mass = 0;
  Vector3 position = {}, velocity = {}, spin = {};
  Vector3 force = {}, torque = {};  ///< of the last step, weight included
  std::size_t kind = 0;             ///< what laws may depend on besides sizes and masses
  double inertia() const { return 0.4 * mass * radius * radius; }
};

/// A flat wall; powder is on the side its unit normal points to.
struct Plane {
  Vector3 point = {}, normal = {}, velocity = {};
};

/// Where tangential forces act, seen from a ball's centre.
enum class Arm {
  surface,  ///< the full radius (Hu 2024, Eq. 2.11)
  contact   ///< r_i - h r_j / (r_i + r_j): the same point for both, which keeps angular momentum
};

struct Settings {
  double time_step = 0;                           ///< s
  Vector3 gravity = {};                           ///< m/s^2
  Arm arm = Arm::contact;                         ///< where contact forces act on balls
  double torque_factor = 1;                       ///< of the sum of torques on a ball (coarse graining)
  std::array<std::optional<double>, 2> period{};  ///< m, in x and y
};

/// Where the energy is and where it went, in J. Rotation counts with inertia over torque factor.
struct Energy {
  double translation = 0, rotation = 0, contact = 0, attraction = 0;
  double normal_work = 0, viscous_work = 0, friction_work = 0, rolling_work = 0, attraction_work = 0,
         gravity_work = 0;  ///< done on the balls since the start
};

template <class Law>
class AllPairs {
 public:
  using MakeLaw = std::function<Law(const laws::PairProperties&)>;

  /// The law of a pair from its properties and the kinds of both balls, or of a ball and the number of a
  /// wall.
  using MakeLawOfKinds = std::function<Law(const laws::PairProperties&, std::size_t, std::size_t)>;

  AllPairs(const Settings& settings, MakeLaw between_balls, MakeLaw with_walls = {})
      : AllPairs(settings, of_any_kind(std::move(between_balls)), of_any_kind(std::move(with_walls))) {}
  AllPairs(const Settings& settings, MakeLawOfKinds between_balls, MakeLawOfKinds with_walls)
      : settings_(settings), between_balls_(std::move(between_balls)), with_walls_(std::move(with_walls)) {}

  std::vector<Ball> balls;
  std::vector<Plane> planes;

  /// Velocity Verlet; forces see the velocities of the half step (Hu 2024, Eqs. 2.66 to 2.75).
  void step() {
    const double dt = settings_.time_step;
    for (auto& ball : balls) kick(ball, 0.5 * dt);
    for (auto& ball : balls) ball.position += dt * ball.velocity;
    for (auto& plane : planes) plane.point += dt * plane.velocity;
    for (auto& ball : balls) {
      ball.force = ball.mass * settings_.gravity;
      ball.torque = {};
      energy_.gravity_work += dot(ball.force, ball.velocity) * dt;
    }
    energy_.contact = energy_.attraction = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t j = i + 1; j < balls.size(); ++j) meet(i, j);
      for (std::size_t wall = 0; wall < planes.size(); ++wall) meet_wall(i, wall);
    }
    for (auto& ball : balls) kick(ball, 0.5 * dt);
  }

  /// Pairs and walls in touch after the last step.
  int contacts() const {
    int count = 0;
    for (const auto& [key, bond] : bonds_) count += bond.overlap > 0 ? 1 : 0;
    return count;
  }

  Energy energy() const {
    Energy sum = energy_;
    for (const auto& ball : balls) {
      sum.translation += 0.5 * ball.mass * dot(ball.velocity, ball.velocity);
      sum.rotation += 0.5 * ball.inertia() / settings_.torque_factor * dot(ball.spin, ball.spin);
    }
    return sum;
  }

  /// kg m/s
  Vector3 momentum() const {
    Vector3 sum;
    for (const auto& ball : balls) sum += ball.mass * ball.velocity;
    return sum;
  }
  /// kg m^2/s about the origin, inertia over torque factor.
  Vector3 angular_momentum() const {
    Vector3 sum;
    for (const auto& ball : balls)
      sum += ball.mass * cross(ball.position, ball.velocity) +
             (ball.inertia() / settings_.torque_factor) * ball.spin;
    return sum;
  }
  /// m, of a pair of balls; negative when apart.
  double overlap(std::size_t i, std::size_t j) const {
    return balls[i].radius + balls[j].radius - length(nearest(balls[i].position - balls[j].position));
  }

 private:
  /// The law of a pair with all it remembers.
  struct Bond {
    Law law;
    std::vector<double> history;
    double overlap = 0;
  };
  using Key = std::pair<std::size_t, std::size_t>;  // second: ball, or wall after all balls

  static MakeLawOfKinds of_any_kind(MakeLaw make) {
    return [make = std::move(make)](const laws::PairProperties& pair, std::size_t, std::size_t) {
      return make(pair);
    };
  }

  void kick(Ball& ball, double time) const {
    ball.velocity += (time / ball.mass) * ball.force;
    ball.spin += (time * settings_.torque_factor / ball.inertia()) * ball.torque;
  }

  Vector3 nearest(Vector3 between) const {
    if (settings_.period[0]) between.x -= *settings_.period[0] * std::round(between.x / *settings_.period[0]);
    if (settings_.period[1]) between.y -= *settings_.period[1] * std::round(between.y / *settings_.period[1]);
    return between;
  }

  /// `other`: kind of the second ball, or number of the wall.
  Bond& bond_of(const Key& key, const MakeLawOfKinds& make, const laws::PairProperties& pair,
                std::size_t other) {
    const auto found = bonds_.find(key);
    if (found != bonds_.end()) return found->second;
    return bonds_
        .emplace(key, Bond{make(pair, balls[key.first].kind, other), std::vector<double>(Law::kHistory + 1)})
        .first->second;
  }

  double arm(double own, double other, double overlap) const {
    if (settings_.arm == Arm::surface || overlap <= 0) return own;
    return own - (std::isinf(other) ? overlap : overlap * other / (own + other));
  }

  void meet(std::size_t a, std::size_t b) {
    Ball &i = balls[a], &j = balls[b];
    const Vector3 between = nearest(i.position - j.position);
    const double distance = length(between), overlap = i.radius + j.radius - distance;
    Bond& bond = bond_of({a, b}, between_balls_, {i.radius, j.radius, i.mass, j.mass}, j.kind);
    const Vector3 normal = (1 / distance) * between;
    const Vector3 arm_i = -arm(i.radius, j.radius, overlap) * normal;
    const Vector3 arm_j = arm(j.radius, i.radius, overlap) * normal;
    const Vector3 velocity = i.velocity + cross(i.spin, arm_i) - j.velocity - cross(j.spin, arm_j);
    const laws::Reaction reaction =
        react(bond, {overlap, normal, velocity, i.spin - j.spin, settings_.time_step});
    push(i, reaction.force, arm_i, reaction.torque);
    push(j, -reaction.force, arm_j, -reaction.torque);
  }

  void meet_wall(std::size_t a, std::size_t wall) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Ball& i = balls[a];
    const Plane& plane = planes[wall];
    const double overlap = i.radius - dot(i.position - plane.point, plane.normal);
    Bond& bond =
        bond_of({a, balls.size() + wall}, with_walls_, {i.radius, kInfinite, i.mass, kInfinite}, wall);
    const Vector3 arm_i = -arm(i.radius, kInfinite, overlap) * plane.normal;
    const Vector3 velocity = i.velocity + cross(i.spin, arm_i) - plane.velocity;
    const laws::Reaction reaction =
        react(bond, {overlap, plane.normal, velocity, i.spin, settings_.time_step});
    push(i, reaction.force, arm_i, reaction.torque);
  }

  laws::Reaction react(Bond& bond, const laws::ContactState& state) {
    const laws::Reaction reaction = bond.law.react(state, bond.history.data());
    bond.overlap = state.overlap;
    energy_.contact += bond.law.contact_energy(state.overlap, bond.history.data());
    energy_.attraction += bond.law.attraction_energy(state.overlap, bond.history.data());
    energy_.normal_work += reaction.normal_power * settings_.time_step;
    energy_.viscous_work += reaction.viscous_power * settings_.time_step;
    energy_.friction_work += reaction.friction_power * settings_.time_step;
    energy_.rolling_work += reaction.rolling_power * settings_.time_step;
    energy_.attraction_work += reaction.attraction_power * settings_.time_step;
    return reaction;
  }

  static void push(Ball& ball, Vector3 force, Vector3 arm, Vector3 torque) {
    ball.force += force;
    ball.torque += cross(arm, force) + torque;
  }

  Settings settings_;
  MakeLawOfKinds between_balls_, with_walls_;
  std::map<Key, Bond> bonds_;
  Energy energy_;
};

}  // namespace diefill::engine::reference
