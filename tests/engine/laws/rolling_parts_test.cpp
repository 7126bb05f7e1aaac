// Rolling resistance: stopping distances, decay of rocking, limits and refusals.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kRadius = 2.5e-4, kGravity = 9.81, kOverlap = 1e-6, kRoot = 1e-3;
const Vector3 kUp{0, 0, 1};

/// Spin of a ball about a fixed axis on a wall with constant load, stepped with the half-step scheme.
template <class Part>
class Rocker {
 public:
  Rocker(const Part& part, double load, double spin, double step)
      : part_(part), load_(load), spin_(spin), step_(step) {}
  double step() {
    spin_ += 0.5 * step_ * torque_ / inertia_;
    angle_ += step_ * spin_;
    torque_ = part_.torque(history_, kUp, {0, spin_, 0}, kRoot, {load_, load_}, load_, step_).y;
    spin_ += 0.5 * step_ * torque_ / inertia_;
    return angle_;
  }
  double spin() const { return spin_; }
  double angle() const { return angle_; }

 private:
  Part part_;
  double load_, spin_, step_, angle_ = 0, torque_ = 0;
  double inertia_ = sphere_on_wall(kRadius).effective_inertia();
  double history_[3] = {};
};

TEST(ConstantTorque, RollingBallStopsAfterThePredictedDistance) {
  // Rolling without slip: deceleration 5/7 mu_r g, way v^2 / (2 a).
  const double friction = 0.1, speed = 0.05;
  const double weight = sphere_mass(kRadius, 1000) * kGravity;
  LawParameters law{.normal = LinearNormal::Parameters{.stiffness = 10},
                    .damping = ConstantDamping::Parameters{.coefficient = 2e-5},
                    // With a dashpot: the ball ends on this spring, and would rock on it.
                    .friction = LudingFriction::Parameters{
                        .stiffness = 2, .damping = 2e-4, .static_friction = 0.8, .dynamic_friction = 0.8}};
  law.rolling = LoadRolling::Parameters{.rolling_friction = friction};
  reference::AllPairs<GeneralLaw> pairs(
      {.time_step = 2e-6, .gravity = {0, 0, -kGravity}, .arm = reference::Arm::surface}, {},
      [&](const PairProperties& pair) { return make_law(law, pair); });
  reference::Ball ball{.radius = kRadius, .mass = sphere_mass(kRadius, 1000)};
  ball.position = {0, 0, kRadius - weight / 10};
  ball.velocity = {speed, 0, 0};
  ball.spin = {0, speed / kRadius, 0};
  pairs.balls = {ball};
  pairs.planes = {{.normal = kUp}};
  const double expected = speed * speed / (2 * friction * kGravity * 5 / 7);
  for (int k = 0; k < 150000; ++k) pairs.step();
  EXPECT_NEAR(pairs.balls[0].position.x, expected, 0.01 * expected);
  EXPECT_LT(std::abs(pairs.balls[0].velocity.x), 1e-3 * speed);
}

/// N m, what a pair that has turned against each other at `spin` (rad/s) for `steps` steps resists with.
template <class Part>
Vector3 torque_after(const Part& part, int steps, Vector3 spin, double load, double step) {
  double history[3] = {};
  Vector3 torque;
  for (int k = 0; k < steps; ++k) torque = part.torque(history, kUp, spin, kRoot, {}, load, step);
  return torque;
}

TEST(ConstantTorque, IsThePrintedOneButForTheFirstSteps) {
  const double load = 1e-5, step = 1e-6;
  const auto pair = sphere_on_wall(kRadius);
  const LoadRolling part({.rolling_friction = 0.1}, pair);
  const double printed = 0.1 * load * kRadius, change = printed * step / pair.effective_inertia();
  // A spin that the torque would stop in four steps: it is there after four, a sixteenth of what would stop
  // the spin in each.
  const Vector3 spin{0, 4 * change, 0};
  EXPECT_NEAR(torque_after(part, 1, spin, load, step).y, -printed / 4, 1e-12 * printed);
  for (const int steps : {4, 5, 1000})
    EXPECT_NEAR(torque_after(part, steps, spin, load, step).y, -printed, 1e-12 * printed);
  // A slow one rolls as far before it is.
  EXPECT_NEAR(torque_after(part, 8, {0, change, 0}, load, step).y, -printed / 2, 1e-12 * printed);
  EXPECT_NEAR(torque_after(part, 17, {0, change, 0}, load, step).y, -printed, 1e-12 * printed);
}

TEST(ConstantTorque, TakesEnergyOutOfEveryTurnToAndFro) {
  const double load = 1e-5, step = 1e-6;
  const auto pair = sphere_on_wall(kRadius);
  const double change = 0.1 * load * kRadius * step / pair.effective_inertia();
  for (const double fastest : {0.1, 1.0, 10.0, 1000.0}) {
    const LoadRolling part({.rolling_friction = 0.1}, pair);
    double history[3] = {}, work = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vector3 spin{fastest * change * std::sin(k * std::numbers::pi / 100), 0, 0};
      work += dot(part.torque(history, kUp, spin, kRoot, {}, load, step), spin);
    }
    EXPECT_LT(work, 0) << fastest;
  }
}

TEST(ConstantTorque, LeavesTorsionAlone) {
  const LoadRolling part({.rolling_friction = 0.1}, spheres(kRadius, kRadius));
  EXPECT_EQ(length(torque_after(part, 100, {0, 0, 5}, 1e-5, 1e-6)), 0);
  const Vector3 tilted = torque_after(part, 100, {3, 4, 100}, 1e-5, 1e-6);
  EXPECT_NEAR(length(tilted), 0.1 * 1e-5 * kRadius / 2, 1e-20);
  EXPECT_EQ(tilted.z, 0);
  EXPECT_NEAR(tilted.x / tilted.y, 0.75, 1e-13);
}

TEST(ConstantTorque, IsNoneWhereNoTimePasses) {
  const LoadRolling part({.rolling_friction = 0.1}, spheres(kRadius, kRadius));
  EXPECT_EQ(length(torque_after(part, 3, {3, 4, 0}, 1e-5, 0)), 0);
}

TEST(ElasticProductTorque, IsThatOfTheOverlapNotTheForce) {
  const ElasticRolling part({.rolling_friction = 0.1, .stiffness = 150}, spheres(kRadius, kRadius));
  const double full = 0.1 * 150 * kOverlap * kRadius / 2;
  EXPECT_NEAR(torque_after(part, 1000, {7, 0, 0}, 0, 1e-6).x, -full, 1e-14 * full);
  // The part along the normal is taken off after the direction is made (Kottlan 2018, Eq. 23).
  EXPECT_NEAR(torque_after(part, 1000, {3, 0, 4}, 0, 1e-6).x, -0.6 * full, 1e-12 * full);
  const ElasticRolling printed({.rolling_friction = 0.1, .stiffness = 150, .harmonic_mean = true},
                               spheres(kRadius, kRadius));
  EXPECT_NEAR(torque_after(printed, 1000, {7, 0, 0}, 0, 1e-6).x, -2 * full, 1e-14 * full);
}

TEST(Epsd2, SmallRockingNeverDecays) {
  const double load = 1e-5;
  const Epsd2Rolling part({.rolling_friction = 0.5, .shear_modulus = 1.13e6}, sphere_on_wall(kRadius));
  const double stiffness = part.coefficient * kRoot;
  const double inertia = sphere_on_wall(kRadius).effective_inertia();
  const double frequency = std::sqrt(stiffness / inertia);
  const double yield_spin = part.arm * load / stiffness * frequency;
  Rocker rocker(part, load, 0.5 * yield_spin, 0.002 / frequency);
  double widest = 0;
  int crossings = 0;
  double before = 0;
  for (int k = 0; k < 100000; ++k) {
    const double angle = rocker.step();
    if (k > 90000) widest = std::max(widest, std::abs(angle));
    crossings += angle * before < 0 ? 1 : 0;
    before = angle;
  }
  EXPECT_NEAR(widest * frequency, 0.5 * yield_spin, 1e-3 * yield_spin);
  // 200 radians of phase: 63.66 half periods.
  EXPECT_NEAR(crossings, 63, 1);
}

TEST(Epsd2, LargeRockingYieldsOnceThenRocksAtTheLimit) {
  // Kinetic energy beyond the spring's goes into plastic rolling: the angle of the turning point is
  // yield + (E - E_yield) / limit; afterwards the ball rocks elastically with the yield amplitude.
  const double load = 1e-5;
  const Epsd2Rolling part({.rolling_friction = 0.5, .shear_modulus = 1.13e6}, sphere_on_wall(kRadius));
  const double stiffness = part.coefficient * kRoot, limit = part.arm * load, yield = limit / stiffness;
  const double inertia = sphere_on_wall(kRadius).effective_inertia();
  const double frequency = std::sqrt(stiffness / inertia), spin = 3 * yield * frequency;
  Rocker rocker(part, load, spin, 0.0005 / frequency);
  double farthest = 0, low = kInfinite, high = 0;
  for (int k = 0; k < 100000; ++k) {
    const double angle = rocker.step();
    farthest = std::max(farthest, angle);
    if (k > 50000) {
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
  }
  const double expected = yield + (0.5 * inertia * spin * spin - 0.5 * limit * yield) / limit;
  EXPECT_NEAR(farthest, expected, 2e-3 * expected);
  EXPECT_NEAR(high - low, 2 * yield, 5e-3 * yield);
}

TEST(LudingRollingPart, RocksWithItsDampingRatio) {
  const auto pair = sphere_on_wall(kRadius);
  const LudingRolling part({.rolling_friction = 1e6,
                            .tangential_stiffness = 50,
                            .stiffness_ratio = 0.5,
                            .damping_ratio = 0.1,
                            .time_step = 1e-8},
                           pair);
  EXPECT_DOUBLE_EQ(part.stiffness, 0.5 * 50 * kRadius * kRadius);
  const double frequency = std::sqrt(part.stiffness / pair.effective_inertia());
  Rocker rocker(part, 1e-5, 1, 0.0005 / frequency);
  double first = 0, second = 0, before = 0;
  int turning = 0;
  double last_spin = 1;
  for (int k = 0; k < 40000; ++k) {
    const double angle = rocker.step();
    if (rocker.spin() * last_spin < 0) (++turning == 1 ? first : turning == 3 ? second : before) = angle;
    last_spin = rocker.spin();
  }
  const double decrement = 2 * std::numbers::pi * 0.1 / std::sqrt(1 - 0.01);
  EXPECT_NEAR(std::log(first / second), decrement, 2e-3 * decrement);
}

TEST(LudingRollingPart, IsCutAtItsLimit) {
  const LudingRolling part({.rolling_friction = 0.1, .time_step = 1e-8}, spheres(kRadius, kRadius));
  double history[3] = {};
  Vector3 torque;
  for (int k = 0; k < 1000; ++k) torque = part.torque(history, kUp, {0, 500, 3}, kRoot, {}, 1e-5, 1e-6);
  EXPECT_NEAR(torque.y, -0.1 * 1e-5 * kRadius / 2, 1e-20);
  EXPECT_EQ(torque.z, 0);
}

TEST(LudingRollingPart, RefusesWhatIsUnstable) {
  const auto pair = spheres(kRadius, kRadius);
  LudingRolling::Parameters given{.rolling_friction = 0.1, .tangential_stiffness = 60};
  EXPECT_THROW(given.check(), std::invalid_argument);  // no time step
  const double stiffness = 60 * pair.effective_radius() * pair.effective_radius();
  const double longest = 2 * std::sqrt(pair.effective_inertia() / stiffness);
  given.time_step = 0.99 * longest;
  EXPECT_NO_THROW(LudingRolling(given, pair));
  given.time_step = 1.01 * longest;
  EXPECT_THROW(LudingRolling(given, pair), std::invalid_argument);
  given.damping_ratio = 0.5;
  EXPECT_THROW(given.check(), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine::laws
