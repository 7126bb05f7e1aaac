// Powders of several sizes and materials: the engine against the slow references of all pairs.
#include <gtest/gtest.h>

#include "engine/coarse_graining/methods.h"
#include "tests/engine/laws/source_laws.h"
#include "tests/engine/mixed_support.h"
#include "tests/engine/reference/all_pairs.h"
#include "tests/engine/reference_dem.h"

namespace diefill::engine {
namespace {

using GeneralReference = reference::AllPairs<coarse_graining::ScaledLaw<laws::GeneralLaw>>;

/// Three sizes of two materials; unlike materials slide more easily than alike ones, and walls do not pull.
GrainMix three_kinds(const laws::ScaledCase& given) {
  auto unlike = given.law.law;
  unlike.friction = laws::CundallFriction::Parameters{.tangential = 60, .friction = 0.1};
  auto walls = given.law.law;
  walls.attraction = {};
  auto mix = mix_of({1, 0.7, 1.6}, given.law.law, unlike, walls);
  mix.scaling = coarse_graining::force_scaling(given.method, given.scale);
  return mix;
}

/// Spheres that fly at each other and at the floor, spinning: large ones and others of both materials by
/// turns.
std::vector<NewGrain> cluster(double speed) {
  std::mt19937_64 random(3);
  std::vector<NewGrain> grains;
  for (int k = 0; k < 12; ++k) {
    const int x = k % 2, y = k / 2 % 2, z = k / 4;
    const Eigen::Vector3d corner(x - 0.5, y - 0.5, z + 0.62);
    NewGrain grain;
    grain.kind = (x + y + z) % 2 == 1 ? TypeNumber{2} : static_cast<TypeNumber>(y);
    grain.position = 2.62 * kMixRadius * (corner + random_vector(random, 0.004));
    grain.velocity = speed * Eigen::Vector3d(-corner.x(), -corner.y(), -0.5 * corner.z());
    grain.angular_velocity = random_vector(random, 0.5 * speed / kMixRadius);
    grains.push_back(grain);
  }
  return grains;
}

GeneralReference reference_for(const SimulationSettings& settings, const std::vector<NewGrain>& grains) {
  reference::Settings same;
  same.time_step = settings.time_step;
  same.arm = reference::Arm::surface;
  const GrainMix mix{settings.types, settings.contact.pairs, settings.contact.scaling};
  same.torque_factor = mix.scaling.torque_factor();
  const auto law = [mix](const std::string& a, const std::string& b, const laws::PairProperties& pair) {
    return coarse_graining::ScaledLaw<laws::GeneralLaw>(
        mix.scaling, laws::make_law(laws::law_between(mix.laws, a, b), mix.scaling.original(pair)));
  };
  GeneralReference reference(
      same, GeneralReference::MakeLawOfKinds([=](const auto& pair, std::size_t i, std::size_t j) {
        return law(mix.kinds[i].material, mix.kinds[j].material, pair);
      }),
      [=](const auto& pair, std::size_t i, std::size_t) {
        return law(mix.kinds[i].material, "steel", pair);
      });
  for (const auto& grain : grains) {
    const GrainShape& shape = mix.kinds[grain.kind].shape;
    reference.balls.push_back({.radius = shape.sphere_radius,
                               .mass = shape.mass,
                               .position = plain(grain.position),
                               .velocity = plain(grain.velocity),
                               .spin = plain(grain.angular_velocity),
                               .kind = grain.kind});
  }
  reference.planes.push_back({.point = {}, .normal = {0, 0, 1}});
  return reference;
}

/// Largest difference after `duration` (s), over kMixRadius and the speed of impact.
double difference(const laws::ScaledCase& given, double time_step, double duration, std::uint64_t& touched) {
  constexpr double kSpeed = 0.3;
  const auto settings = settings_of(three_kinds(given), time_step);
  const auto grains = cluster(kSpeed);
  Simulation simulation(settings, {steel_floor()});
  simulation.add_grains(grains);
  auto reference = reference_for(settings, grains);
  for (int k = 0; k < static_cast<int>(std::lround(duration / time_step)); ++k) {
    simulation.step();
    reference.step();
    touched = std::max(touched, simulation.touching_pairs());
  }
  double most = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& ball = reference.balls[k];
    const Eigen::Vector3d spin = simulation.angular_velocity(place_of(simulation, k)) - eigen(ball.spin);
    most = std::max({most, (position_of(simulation, k) - eigen(ball.position)).norm() / kMixRadius,
                     (velocity_of(simulation, k) - eigen(ball.velocity)).norm() / kSpeed,
                     kMixRadius * spin.norm() / kSpeed});
  }
  return most;
}

class MixedLaws : public ::testing::TestWithParam<laws::ScaledCase> {};

TEST_P(MixedLaws, EngineMovesGrainsAsAllPairsDo) {
  // The reference sees forces with velocities of the half step, the engine with predicted ones: both meet as
  // the time step goes to nothing.
  std::uint64_t touched = 0;
  const double coarse = difference(GetParam(), 2e-8, 6e-5, touched);
  const double fine = difference(GetParam(), 5e-9, 6e-5, touched);
  EXPECT_GE(touched, 4U);
  EXPECT_LT(fine, 5e-4);
  EXPECT_LT(fine, 0.5 * coarse);
}

INSTANTIATE_TEST_SUITE_P(Sources, MixedLaws, ::testing::ValuesIn(laws::laws_under({"scaled-up particle"})),
                         [](const auto& instance) {
                           std::string name = instance.param.law.name + "_" + instance.param.method;
                           for (char& letter : name)
                             if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
                           return name;
                         });

struct MixCase {
  std::string name;
  Model model;
  LeverArm arm = LeverArm::contact;
  double work_of_adhesion = 0;
  bool periodic = false;
};

/// The shape of `model` with all lengths times `scale` and its density kept.
GrainShape scaled_shape(Model model, double scale) {
  const double volume = scale * scale * scale;
  switch (model) {
    case Model::a:
      return model_a(1.5e-4 * scale, 7.63e-8 * volume);
    case Model::b:
      return model_b(1.5e-4 * scale, 7.63e-8 * volume);
    case Model::c:
      return model_c(8.9e-5 * scale, 7.63e-8 * volume);
    default:
      return model_d(7.84e-5 * scale, 7.63e-8 * volume);
  }
}

class MixedShapes : public ::testing::TestWithParam<MixCase> {
 protected:
  static constexpr double kSizes[3] = {1, 0.6, 1.5};

  /// Between kinds i and j; kinds 0 and 2 are of one material.
  ContactParameters contact(std::size_t i, std::size_t j) const {
    ContactParameters parameters = base_;
    parameters.work_of_adhesion = GetParam().work_of_adhesion;
    if (i % 2 != j % 2) {
      parameters.reduced_modulus *= 0.5;
      parameters.friction = 0.2;
      parameters.work_of_adhesion *= 3;
    }
    return parameters;
  }
  ContactParameters wall_contact(std::size_t kind) const {
    ContactParameters parameters = base_;
    parameters.friction = kind % 2 == 0 ? 0.15 : 0.4;
    return parameters;
  }
  GrainMix mix() const {
    GrainMix mix;
    for (std::size_t k = 0; k < 3; ++k)
      mix.kinds.push_back({scaled_shape(GetParam().model, kSizes[k]), k % 2 == 0 ? "iron" : "wax"});
    mix.laws = {{"iron", "iron", bierwisch_parts(contact(0, 0))},
                {"wax", "wax", bierwisch_parts(contact(1, 1))},
                {"iron", "wax", bierwisch_parts(contact(0, 1))},
                {"iron", "steel", bierwisch_parts(wall_contact(0))},
                {"wax", "steel", bierwisch_parts(wall_contact(1))}};
    return mix;
  }
  ReferenceKinds reference_kinds() const {
    ReferenceKinds kinds;
    for (const double size : kSizes) kinds.shapes.push_back(scaled_shape(GetParam().model, size));
    kinds.grain_contact = [this](std::size_t i, std::size_t j) { return contact(i, j); };
    kinds.wall_contact = [this](std::size_t kind) { return wall_contact(kind); };
    return kinds;
  }

 private:
  ContactParameters base_ = {.reduced_modulus = 1e7, .damping = 100, .tangential = 100, .friction = 0.5};
};

TEST_P(MixedShapes, EngineMovesGrainsAlike) {
  auto settings = settings_of(mix(), 1e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 2e-5;
  settings.lever_arm = GetParam().arm;
  const double size = 2 * 1.5 * scaled_shape(GetParam().model, 1).bounding_radius();
  if (GetParam().periodic) settings.period = {3.6 * size, 3.6 * size};
  WallBodySpec floor = plate(2e-3, 1.5e-4, [size](double time) {
    BodyMotion motion;
    motion.velocity = {0.3, 0.1, 0};
    motion.translation = motion.velocity * time - Eigen::Vector3d(0, 0, 1.3 * size);
    return motion;
  });
  floor.material = "steel";
  const auto cloud = mixed_cloud({3, 3, 3}, 0.8 * size, 0.5, 3, 42);

  Simulation simulation(settings, {floor});
  simulation.add_grains(cloud);
  ReferenceDem reference(settings, {floor}, reference_kinds());
  for (const auto& grain : cloud) reference.add(grain);
  const PeriodicBox box(settings.period);
  std::uint64_t touched = 0;
  bool wall_met = false;
  for (int k = 0; k < 600; ++k) {
    simulation.step();
    reference.step();
    touched = std::max(touched, simulation.touching_pairs());
    wall_met = wall_met || simulation.wall_load(0).force.norm() > 0;
  }
  double worst_place = 0, worst_speed = 0, worst_spin = 0;
  for (std::size_t id = 0; id < cloud.size(); ++id) {
    const auto& expected = reference.grains()[id];
    const std::size_t k = place_of(simulation, id);
    ASSERT_EQ(simulation.grains().kind[k], cloud[id].kind);
    const Eigen::Vector3d apart = box.wrapped(simulation.grains().position[k] - expected.position);
    worst_place = std::max(worst_place, apart.norm() / size);
    worst_speed = std::max(worst_speed, (simulation.grains().velocity[k] - expected.velocity).norm() / 0.3);
    worst_spin = std::max(worst_spin, (simulation.grains().spin[k] - expected.spin).norm() * size / 0.3);
  }
  EXPECT_LT(worst_place, 1e-11);
  EXPECT_LT(worst_speed, 1e-9);
  EXPECT_LT(worst_spin, 1e-8);
  EXPECT_GT(touched, 8U);
  EXPECT_TRUE(wall_met);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, MixedShapes,
    ::testing::Values(MixCase{"A", Model::a}, MixCase{"B", Model::b},
                      MixCase{"BCohesivePeriodic", Model::b, LeverArm::contact, 0.01, true},
                      MixCase{"CContactCohesive", Model::c, LeverArm::contact, 0.1},
                      MixCase{"DContact", Model::d},
                      MixCase{"DCenterPeriodic", Model::d, LeverArm::center, 0.01, true}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace diefill::engine
