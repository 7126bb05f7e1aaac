// Walls of triangles: as flat as a plane however it is cut up, faces, edges and corners as closed forms have
// them, each place counted once.
#include "tests/engine/mesh_walls.h"

#include <gtest/gtest.h>

#include "engine/limits/pinched_grains.h"
#include "engine/observe/energy_balance.h"

namespace diefill::engine {
namespace {

/// Hertz' law F = k h^1.5 against a flat wall: k in N/m^1.5 (Bierwisch 2009, Eq. 2.1).
double hertz_stiffness(const SimulationSettings& settings, double effective) {
  return 2.0 / 3.0 * wall_contact(settings).reduced_modulus * std::sqrt(effective);
}

/// m, overlap at which the spring holds all the energy of a grain of this speed (m/s).
double deepest_of_rebound(const SimulationSettings& settings, double effective, double speed) {
  return std::pow(1.25 * settings.shape().mass * speed * speed / hertz_stiffness(settings, effective), 0.4);
}

SimulationSettings elastic() {
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 2e-7);
  wall_contact(settings)->friction = 0;
  return settings;
}

constexpr double kEdge = 1e-3;  // m, of the box that grains are thrown at

WallBodySpec target() {
  return triangle_box(Eigen::Vector3d::Constant(-kEdge), Eigen::Vector3d::Zero(), false);
}

/// One grain thrown at a wall, until it has come off again.
Simulation thrown(const SimulationSettings& settings, const WallBodySpec& wall, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& velocity) {
  Simulation simulation(settings, {wall});
  NewGrain grain;
  grain.position = from;
  grain.velocity = velocity;
  simulation.add_grains({grain});
  bool touched = false;
  for (int k = 0; k < 100000 && !(touched && simulation.touching_pairs() == 0); ++k) {
    simulation.step();
    touched = touched || simulation.touching_pairs() > 0;
    EXPECT_LE(simulation.touching_pairs(), 1U);
  }
  EXPECT_TRUE(touched);
  return simulation;
}

class Rebound : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(Rebound, OnFaceEdgeAndCornerIsThatOfHertz) {
  const auto settings = elastic();
  const double speed = 0.3, radius = settings.shape().sphere_radius;
  const Eigen::Vector3d outward = GetParam().normalized();
  // Onto the middle of the face or edge, or onto the corner at the origin.
  const Eigen::Vector3d foot = (GetParam().array() == 0).select(Eigen::Array3d::Constant(-0.5 * kEdge), 0.0);
  const auto simulation = thrown(settings, target(), foot + 1.01 * radius * outward, -speed * outward);
  const double deepest = deepest_of_rebound(settings, radius, speed);
  EXPECT_NEAR(simulation.deepest_overlap_of_run(), deepest, 1e-4 * deepest);
  EXPECT_LT((velocity_of(simulation, 0) - speed * outward).norm(), 1e-4 * speed);
}

INSTANTIATE_TEST_SUITE_P(MeshWalls, Rebound,
                         ::testing::Values(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 1),
                                           Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.2, 0, 1),
                                           Eigen::Vector3d(0.3, 1, 0.1)));

/// CAD leaves steps of some 1e-8 m between faces: seen from beside its plane, the edge of the upper face is
/// nearer than the side, but the grain is not behind it.
TEST(MeshWalls, EdgeThatStandsOutByAStepOfTheCadPushesNothingThrough) {
  constexpr double kStep = 1e-8;  // m
  const auto settings = elastic();
  const double speed = 0.3, radius = settings.shape().sphere_radius;
  auto wall = target();
  for (auto& triangle : wall.triangles) {
    const auto level = [](const Eigen::Vector3d& corner) { return corner.z() == 0; };
    if (!std::all_of(triangle.corner.begin(), triangle.corner.end(), level)) continue;
    for (auto& corner : triangle.corner)
      if (corner.x() == 0) corner.x() = kStep;
  }
  const auto simulation =
      thrown(settings, wall, {1.01 * radius, -0.5 * kEdge, -5e-7}, -speed * Eigen::Vector3d::UnitX());
  const double deepest = deepest_of_rebound(settings, radius, speed);
  EXPECT_NEAR(simulation.deepest_overlap_of_run(), deepest, 1e-3 * deepest);
  EXPECT_LT((velocity_of(simulation, 0) - speed * Eigen::Vector3d::UnitX()).norm(), 1e-2 * speed);
}

/// Of two edges that are almost one, tilted by 2e-5, each had the other for a place that is nearer.
TEST(MeshWalls, EdgesOfTwoFacesThatAreAlmostOneAreTouchedOnce) {
  constexpr double kTilt = 2e-5;
  const auto settings = elastic();
  const double speed = 0.3, radius = settings.shape().sphere_radius;
  const Eigen::Vector3d foot(0, -0.5 * kEdge, 0), outward = Eigen::Vector3d(1, 0, 1).normalized();
  auto wall = target();
  for (auto& triangle : wall.triangles) {
    const auto level = [](const Eigen::Vector3d& corner) { return corner.z() == 0; };
    if (!std::all_of(triangle.corner.begin(), triangle.corner.end(), level)) continue;
    for (auto& corner : triangle.corner)
      if (corner.x() == 0) corner.x() = kTilt * (corner.y() - foot.y());
  }
  const auto simulation = thrown(settings, wall, foot + 1.01 * radius * outward, -speed * outward);
  const double deepest = deepest_of_rebound(settings, radius, speed);
  EXPECT_NEAR(simulation.deepest_overlap_of_run(), deepest, 1e-3 * deepest);
  EXPECT_LT((velocity_of(simulation, 0) - speed * outward).norm(), 1e-3 * speed);
}

TEST(MeshWalls, TakeTheEffectiveRadiusAskedFor) {
  const auto settings = elastic();
  const double radius = settings.shape().sphere_radius, speed = 0.3;
  auto wall = target();
  wall.contact_radius = 1.5e-4;
  const auto simulation = thrown(settings, wall, {-0.5 * kEdge, -0.5 * kEdge, 1.01 * radius}, {0, 0, -speed});
  const double deepest = deepest_of_rebound(settings, effective_radius(radius, 1.5e-4), speed);
  EXPECT_NEAR(simulation.deepest_overlap_of_run(), deepest, 1e-4 * deepest);
}

/// A point in the plane that flies at the origin's spring of this length, by a fourth-order scheme.
Eigen::Vector2d scattered(Eigen::Vector2d place, Eigen::Vector2d velocity, double length, double stiffness,
                          double mass) {
  const auto pull = [&](const Eigen::Vector2d& at) -> Eigen::Vector2d {
    const double overlap = std::max(0.0, length - at.norm());
    return stiffness / mass * std::pow(overlap, 1.5) * at.normalized();
  };
  constexpr double kStep = 5e-8;
  for (bool touched = false; !touched || place.norm() < length; touched = touched || place.norm() < length) {
    const Eigen::Vector2d a = pull(place), b = pull(place + 0.5 * kStep * velocity);
    const Eigen::Vector2d c = pull(place + 0.5 * kStep * (velocity + 0.5 * kStep * a));
    const Eigen::Vector2d d = pull(place + kStep * (velocity + 0.5 * kStep * b));
    place += kStep * (velocity + kStep / 6 * (a + b + c));
    velocity += kStep / 6 * (a + 2 * b + 2 * c + d);
  }
  return velocity;
}

TEST(MeshWalls, ScatterFromAnEdgeAsASpringAboutIt) {
  const auto settings = elastic();
  const double radius = settings.shape().sphere_radius, speed = 0.3;
  const Eigen::Vector2d from(0.5 * radius, 1.0 * radius), velocity(0, -speed);
  const Eigen::Vector2d expected =
      scattered(from, velocity, radius, hertz_stiffness(settings, radius), settings.shape().mass);
  const auto simulation = thrown(settings, target(), {from.x(), -0.5 * kEdge, from.y()}, {0, 0, -speed});
  const Eigen::Vector3d off = velocity_of(simulation, 0);
  EXPECT_NEAR(off.x(), expected.x(), 1e-3 * speed);
  EXPECT_NEAR(off.y(), 0, 1e-12);
  EXPECT_NEAR(off.z(), expected.y(), 1e-3 * speed);
}

/// A tool that is tilted, slides, turns and shakes.
BodyMotion swaying(double time) {
  BodyMotion motion;
  motion.angular_velocity = {0, 0, 3};
  motion.rotation = Eigen::AngleAxisd(3 * time, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                    Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitX()).toRotationMatrix();
  motion.translation = {1e-4 * std::sin(600 * time), 0, 2e-6 * std::sin(900 * time)};
  motion.velocity = {0.06 * std::cos(600 * time), 0, 1.8e-3 * std::cos(900 * time)};
  return motion;
}

struct Ride {
  Simulation simulation;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
};

/// Three balls that slide, roll and stick on a wall; force and torque on it over all steps.
Ride ride(WallBodySpec wall) {
  auto settings = weightless(Model::b, {}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  wall.motion = swaying;
  Ride ride{Simulation(settings, {wall})};
  std::vector<NewGrain> balls(3);
  const double radius = settings.shape().sphere_radius;
  balls[0].position = {-1e-3, -2e-3, radius};
  balls[0].velocity = {0.09, 0.01, 0};
  balls[1].position = {-1e-3, 0, radius};
  balls[1].velocity = {0.05, 0, 0};
  balls[1].angular_velocity = {0, 0.05 / radius, 0};
  balls[2].position = {2e-3, 2e-3, radius + 1e-6};
  ride.simulation.add_grains(balls);
  for (int k = 0; k < 20000; ++k) {
    ride.simulation.step();
    ride.force += ride.simulation.wall_load(0).force;
    ride.torque += ride.simulation.wall_load(0).torque;
  }
  return ride;
}

TEST(MeshWalls, CutUpPlaneIsAPlane) {
  WallBodySpec plane;
  plane.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  const Ride flat = ride(plane), cut = ride(tessellated_plane(6e-3, 1.2e-4));
  EXPECT_GT(flat.simulation.touching_pairs(), 0U);
  EXPECT_EQ(cut.simulation.touching_pairs(), flat.simulation.touching_pairs());
  for (std::uint64_t ball = 0; ball < 3; ++ball) {
    EXPECT_LT((position_of(cut.simulation, ball) - position_of(flat.simulation, ball)).norm(), 1e-12);
    EXPECT_LT((velocity_of(cut.simulation, ball) - velocity_of(flat.simulation, ball)).norm(), 1e-9);
  }
  EXPECT_GT((position_of(flat.simulation, 0) - Eigen::Vector3d(-1e-3, -2e-3, 0)).norm(), 1.5e-3);
  EXPECT_LT((cut.force - flat.force).norm(), 1e-9 * flat.force.norm());
  EXPECT_LT((cut.torque - flat.torque).norm(), 1e-9 * flat.torque.norm());
}

TEST(MeshWalls, CutUpPlaneIsAPlaneForClumps) {
  const auto slide = [](WallBodySpec wall) {
    auto settings = weightless(Model::d, {}, 2e-6);
    settings.gravity = {0, 0, -9.81};
    Simulation simulation(settings, {std::move(wall)});
    NewGrain grain;
    grain.position = {-3e-4, 0, 2.4e-4};
    grain.velocity = {0.05, 0.02, 0};
    simulation.add_grains({grain});
    run_steps(simulation, 3000);
    return simulation;
  };
  WallBodySpec plane;
  plane.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  const auto flat = slide(plane), cut = slide(tessellated_plane(2e-3, 9e-5));
  EXPECT_GT(flat.overlaps_of_run().walls, 0);
  EXPECT_LT((position_of(cut, 0) - position_of(flat, 0)).norm(), 1e-11);
}

/// The overlap (m) at which a ball comes to rest in the corner where `faces` (all through the origin) meet,
/// under a weight along -`up`; expects one contact a face.
double resting_overlap(const WallBodySpec& wall, const Eigen::Vector3d& up, double height,
                       std::size_t contacts) {
  auto settings = weightless(Model::a, {}, 2e-6);
  wall_contact(settings)->friction = 0;
  settings.gravity = -9.81 * up;
  Simulation simulation(settings, {wall});
  NewGrain grain;
  grain.position = height * up;
  simulation.add_grains({grain});
  run_steps(simulation, 40000);
  EXPECT_EQ(simulation.touching_pairs(), contacts);
  EXPECT_LT(velocity_of(simulation, 0).norm(), 1e-7);
  return simulation.deepest_overlap();
}

double hertz_overlap(double force) {
  const auto settings = weightless(Model::a, {}, 2e-6);
  return std::pow(force / hertz_stiffness(settings, settings.shape().sphere_radius), 2.0 / 3.0);
}

TEST(MeshWalls, BallInACornerTouchesThreeFaces) {
  const auto shape = thesis_shape(Model::a);
  const auto vessel = triangle_box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(2e-3), true);
  const Eigen::Vector3d up = Eigen::Vector3d::Ones().normalized();
  const double rest = std::sqrt(3.0) * shape.sphere_radius;
  const double expected = hertz_overlap(shape.mass * 9.81 / std::sqrt(3.0));
  EXPECT_NEAR(resting_overlap(vessel, up, rest, 3), expected, 1e-5 * expected);
}

/// A groove along y whose sides rise at `slope` (rad).
WallBodySpec groove(double slope) {
  const double reach = 2e-3, rise = reach * std::tan(slope);
  WallBodySpec body;
  add_rectangle(body, {-reach, -reach, rise}, {0, -reach, 0}, {0, reach, 0}, {-reach, reach, rise});
  add_rectangle(body, {0, -reach, 0}, {reach, -reach, rise}, {reach, reach, rise}, {0, reach, 0}, true);
  return body;
}

TEST(MeshWalls, GrooveIsTouchedOnBothSides) {
  const auto shape = thesis_shape(Model::a);
  for (const double slope : {0.25, 0.8, 1.2}) {
    const double expected = hertz_overlap(shape.mass * 9.81 / (2 * std::cos(slope)));
    const double rest = shape.sphere_radius / std::cos(slope);
    EXPECT_NEAR(resting_overlap(groove(slope), Eigen::Vector3d::UnitZ(), rest, 2), expected, 1e-5 * expected)
        << slope;
  }
}

TEST(MeshWalls, SeamOfACurvedSurfaceIsTouchedOnceAndKeepsTheEnergy) {
  auto settings = elastic();
  settings.gravity = {0, 0, -9.81};
  settings.time_step = 2e-6;
  Simulation simulation(settings, {groove(0.05)});
  NewGrain grain;
  grain.position = {-1e-4, 0, 1.05 * settings.shape().sphere_radius};
  grain.velocity = {0.02, 0.03, 0};
  simulation.add_grains({grain});
  int crossings = 0;
  for (int k = 0; k < 10000; ++k) {
    const bool left = position_of(simulation, 0).x() < 0;
    simulation.step();
    crossings += left != (position_of(simulation, 0).x() < 0);
    ASSERT_LE(simulation.touching_pairs(), 1U);
  }
  EXPECT_GT(crossings, 0);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-3);
}

TEST(MeshWalls, CentreBehindTheSurfaceIsPushedBackAndReported) {
  auto settings = elastic();
  Simulation simulation(settings, {target()});
  const double radius = settings.shape().sphere_radius;
  NewGrain grain;
  grain.position = {-0.5 * kEdge, -0.5 * kEdge, -0.2 * radius};
  simulation.add_grains({grain});
  simulation.step();
  EXPECT_NEAR(simulation.overlaps_of_run().walls, 1.2 * radius, 1e-6 * radius);
  simulation.step();
  EXPECT_GT(velocity_of(simulation, 0).z(), 0);
  EXPECT_EQ(simulation.touching_pairs(), 1U);
}

TEST(MeshWalls, ThinWallIsTouchedOnItsNearSideOnly) {
  const auto settings = elastic();
  const double radius = settings.shape().sphere_radius;
  const auto sheet = triangle_box({-kEdge, -kEdge, -0.2 * radius}, {0, 0, 0}, false);
  const auto simulation = thrown(settings, sheet, {-0.4 * kEdge, -0.5 * kEdge, 1.01 * radius}, {0, 0, -0.3});
  EXPECT_NEAR(velocity_of(simulation, 0).z(), 0.3, 1e-4);
}

TEST(MeshWalls, NameWhatTheyPinch) {
  auto settings = weightless(Model::a, {}, 1e-9);
  const double radius = settings.shape().sphere_radius;
  WallBodySpec die = target();
  WallBodySpec shoe = triangle_box({-kEdge, -kEdge, 1.2 * radius}, {0, 0, kEdge}, false);
  shoe.motion = [](double time) {
    BodyMotion motion;
    motion.velocity.x() = 0.2;
    motion.translation.x() = 0.2 * time;
    return motion;
  };
  Simulation simulation(settings, {die, shoe});
  NewGrain grain;
  grain.position = {-0.5 * kEdge, -0.5 * kEdge, 0.6 * radius};
  simulation.add_grains({grain});
  simulation.step();
  const auto pinched = pinched_grains(simulation, 0.3);
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_NEAR(pinched[0].overlap, 0.4, 1e-6);
}

TEST(MeshWalls, RefuseTrianglesWithoutAreaAndPartsOfTwoKinds) {
  const auto settings = elastic();
  WallBodySpec line;
  line.triangles = {{{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, 0, 0)}}};
  EXPECT_THROW(Simulation(settings, {line}), std::invalid_argument);
  auto both = target();
  both.centres = {Eigen::Vector3d::Zero()};
  EXPECT_THROW(Simulation(settings, {both}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
