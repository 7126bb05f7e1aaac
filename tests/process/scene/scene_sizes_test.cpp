// Powders of several sizes from the scene to the engine: classes and their shares, kinds, laws of pairs,
// pouring.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/contact/pair_laws.h"
#include "engine/simulation/simulation.h"
#include "process/powder/material.h"
#include "process/powder/mixed_powder.h"
#include "process/powder/tool_surface.h"
#include "process/setup/pour.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

namespace laws = engine::laws;

constexpr const char* kTwo =
    "sizes = { distribution = \"classes\", classes = [{ diameter = \"2.1 mm\", share = 0.7 }, { diameter = "
    "\"1.4 mm\", share = 0.3 }] }";

Scene scene_with(const std::string& sizes, const std::string& preset = "Distaloy AE",
                 const std::string& more = "") {
  const SceneFolder folder;
  std::string text = support::exchanged(faultless_scene(), "grain_diameter = \"1.88 mm\"", sizes);
  text = support::exchanged(text, "preset = \"Distaloy AE\"", "preset = \"" + preset + "\"");
  return read_scene(folder.write(support::exchanged(text, "[[tool]]", more + "\n[[tool]]")));
}

double mean_cube(const PowderSpec& powder) {
  double sum = 0;
  for (const auto& one : powder.sizes) sum += one.number_share * std::pow(one.diameter, 3);
  return sum;
}

TEST(SceneSizes, ClassesByMassAreHeldByTheirMass) {
  const PowderSpec powder = scene_with(kTwo).powder;
  ASSERT_EQ(powder.sizes.size(), 2U);
  EXPECT_NEAR(powder.sizes[0].diameter, 1.4e-3, 1e-15);
  EXPECT_NEAR(powder.sizes[1].diameter, 2.1e-3, 1e-15);
  // 0.3 of the mass in grains of (2/3)^3 of the others' mass.
  const double small = 0.3 / std::pow(1.4, 3), large = 0.7 / std::pow(2.1, 3);
  EXPECT_NEAR(powder.sizes[0].number_share, small / (small + large), 1e-12);
  EXPECT_NEAR(std::pow(powder.grain_diameter, 3), mean_cube(powder), 1e-20);
  EXPECT_EQ(smallest_grain(powder), powder.sizes[0].diameter);
  EXPECT_EQ(largest_grain(powder), powder.sizes[1].diameter);
}

TEST(SceneSizes, ClassesByNumberAndCutOffs) {
  const std::string three =
      "classes = [{ diameter = \"1 mm\", share = 3 }, { diameter = \"2 mm\", share = 1 }, { diameter = \"3 "
      "mm\", share = 1 }]";
  const PowderSpec all =
      scene_with("sizes = { distribution = \"classes\", basis = \"number\", " + three + " }").powder;
  ASSERT_EQ(all.sizes.size(), 3U);
  EXPECT_NEAR(all.sizes[0].number_share, 0.6, 1e-12);
  const PowderSpec cut =
      scene_with("sizes = { distribution = \"classes\", basis = \"number\", largest = \"2.5 mm\", " + three +
                 " }")
          .powder;
  ASSERT_EQ(cut.sizes.size(), 2U);
  EXPECT_NEAR(cut.sizes[0].number_share, 0.75, 1e-12);
}

TEST(SceneSizes, OneClassIsPowderOfOneSize) {
  const Scene one = scene_with(
      "sizes = { distribution = \"classes\", classes = [{ diameter = \"1.8816 mm\", share = 0.2 }] }");
  EXPECT_TRUE(one.powder.sizes.empty());
  EXPECT_NEAR(one.powder.grain_diameter, 1.8816e-3, 1e-15);
  EXPECT_EQ(engine_settings(one, 1.0).types.size(), 1U);
}

TEST(SceneSizes, LogNormalHasItsMedianByMass) {
  const PowderSpec powder = scene_with(
                                "sizes = { distribution = \"log-normal\", median = \"1.9 mm\", log_deviation "
                                "= 0.2, number_of_classes = 12 }")
                                .powder;
  ASSERT_EQ(powder.sizes.size(), 12U);
  // Mean mass of a log-normal: number median m_n = m exp(-3 s^2), mean cube m_n^3 exp(9 s^2 / 2).
  const double expected = 1.9e-3 * std::exp(-3 * 0.04 + 1.5 * 0.04);
  EXPECT_NEAR(powder.grain_diameter, expected, 1e-9 * expected);
  const PowderSpec by_number = scene_with(
                                   "sizes = { distribution = \"log-normal\", basis = \"number\", mean = \"2 "
                                   "mm\", deviation = \"0.4 mm\" }")
                                   .powder;
  EXPECT_EQ(by_number.sizes.size(), 8U);
  // <d^3> = mean^3 (1 + v^2)^3 with v the deviation over the mean.
  EXPECT_NEAR(by_number.grain_diameter, 2e-3 * 1.04, 1e-9);
}

TEST(SceneSizes, KindsHaveOneDensityAndScaleAsRigidBodies) {
  const Scene scene = scene_with(kTwo);
  const auto settings = engine_settings(scene, 1.0);
  ASSERT_EQ(settings.types.size(), 2U);
  const auto mean_shape = mean_grain(scene);
  double mean = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& shape = settings.types[k].shape;
    const double factor = scene.powder.sizes[k].diameter / scene.powder.grain_diameter;
    EXPECT_NEAR(2 * shape.bounding_radius(), scene.powder.sizes[k].diameter, 1e-15);
    EXPECT_NEAR(shape.mass / shape.solid_volume, mean_shape.mass / mean_shape.solid_volume, 1e-6);
    EXPECT_NEAR(shape.inertia.x(), mean_shape.inertia.x() * std::pow(factor, 5), 1e-9 * shape.inertia.x());
    mean += scene.powder.sizes[k].number_share * shape.mass;
  }
  EXPECT_NEAR(mean, mean_shape.mass, 1e-9 * mean);
}

/// Force of the law between two kinds, or of kind i with a tool where j is none, at `overlap` (m) and
/// approach speed `speed` (m/s).
double force_of(const engine::SimulationSettings& settings, std::size_t i, std::optional<std::size_t> j,
                double overlap, double speed) {
  const engine::ParticleTypes types(settings.types);
  const auto one = static_cast<engine::ClassNumber>(i);
  const auto law = j ? engine::law_between(types, settings.contact, one, static_cast<engine::ClassNumber>(*j))
                     : engine::law_at_wall(types, settings.contact, one, {});
  return speed > 0 ? law.damping(overlap) * speed : law.stiffness(overlap);
}

TEST(SceneSizes, LawsOfPairsAreTheClosedForms) {
  const Scene scene = scene_with(kTwo, "ASC100.29 A1");
  const auto settings = engine_settings(scene, 1.0);
  const double radius[] = {0.7e-3, 1.05e-3}, overlap = 1e-5;
  const auto& powder = scene.powder;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = i; j < 2; ++j) {
      const double reduced = radius[i] * radius[j] / (radius[i] + radius[j]);
      // Hertz with 2/3 E~: dF/dh = E~ sqrt(R_eff h); gamma_n of the smaller sphere times sqrt(R_eff h).
      const double stiffness = powder.reduced_modulus * std::sqrt(reduced * overlap);
      EXPECT_NEAR(force_of(settings, i, j, overlap, 0), stiffness, 1e-9 * stiffness);
      const double damping = powder.damping_over_radius * radius[i] * std::sqrt(reduced * overlap);
      EXPECT_NEAR(force_of(settings, i, j, overlap, 1), damping, 1e-9 * damping);
    }
  for (std::size_t i = 0; i < 2; ++i) {  // OP-5: gamma_n from the powder's sphere, R_eff from both
    const double damping = powder.damping_over_radius * radius[i] * std::sqrt(radius[i] * overlap);
    EXPECT_NEAR(force_of(settings, i, std::nullopt, overlap, 1), damping, 1e-9 * damping);
  }
  const auto& law =
      laws::law_between(settings.contact.pairs, settings.types[0].material, settings.types[1].material);
  const double scale = coarse_graining_factor(powder);
  EXPECT_NEAR(law.normal.of<laws::BierwischNormal>()->work_of_adhesion, scale * powder.work_of_adhesion,
              1e-15);
  EXPECT_NEAR(law.friction.of<laws::CundallFriction>()->tangential, powder.tangential_over_radius * radius[0],
              1e-9);
}

// Where all sizes are nearly one, so are step and law of the powder of that size.
TEST(SceneSizes, NearlyEqualSizesHaveTheStepOfOneSize) {
  const Scene nearly = scene_with(
      "sizes = { distribution = \"classes\", classes = [{ diameter = \"1.8816 mm\", share = 1 }, { diameter "
      "= "
      "\"1.8817 mm\", share = 1 }] }");
  const Scene one = scene_with("grain_diameter = \"1.88 mm\"");
  const auto mixed = engine_settings(nearly, 1.0), plain = engine_settings(one, 1.0);
  EXPECT_NEAR(critical_time_step(mixed, 1.0), critical_time_step(plain, 1.0),
              0.3 * critical_time_step(plain, 1.0));
  EXPECT_LE(critical_time_step(mixed, 1.0), critical_time_step(plain, 1.0) * (1 + 1e-3));
  EXPECT_EQ(mixed.gravity, plain.gravity);
  EXPECT_NEAR(mixed.air_viscosity, plain.air_viscosity, 1e-3 * plain.air_viscosity);
}

TEST(SceneSizes, ContactLawsAreTakenAsTheyStand) {
  const Scene scene = scene_with(kTwo, "ASC100.29 initial B", R"([contact]
normal = { law = "JKR", modulus = "5 MPa", surface_energy = "0.01 J/m^2" }
damping = { law = "restitution", restitution = 0.5 }
rolling = { law = "EPSD2", rolling_friction = 0.2, shear_modulus = "2 MPa" }
)");
  const auto settings = engine_settings(scene, 1.0);
  ASSERT_EQ(settings.types.size(), 2U);
  EXPECT_EQ(settings.contact.pairs.size(), 5U);
  EXPECT_NO_THROW(engine::Simulation(settings, {}));
}

Tooling floor_below() {
  Tooling tooling;
  tooling.standing.include(Eigen::Vector3d::Constant(-1));
  tooling.standing.include(Eigen::Vector3d::Constant(1));
  return tooling;
}

TEST(PourSizes, GivesTheMassAndTheSharesAndNoOverlap) {
  const Scene scene = scene_with(kTwo);
  const auto settings = engine_settings(scene, 1.0);
  const auto grains = pour(scene, settings, floor_below());
  const auto& kinds = settings.types;
  double solid = 0, small = 0;
  for (const auto& grain : grains) {
    solid += kinds[grain.kind].shape.solid_volume;
    if (grain.kind == 0) small += kinds[0].shape.solid_volume;
  }
  const Eigen::Vector3d box = scene.pour.upper - scene.pour.lower;
  const double wanted = box[0] * box[1] * scene.pour.fill_height * expected_solid_fraction(scene);
  EXPECT_NEAR(solid, wanted, 2 * kinds[1].shape.solid_volume);
  EXPECT_NEAR(small / solid, 0.3, 0.01);
  double top = 0;
  for (std::size_t a = 0; a < grains.size(); ++a) {
    const double radius = kinds[grains[a].kind].shape.bounding_radius();
    top = std::max(top, grains[a].position[2] + radius);
    EXPECT_GT(grains[a].position[2], 0.999 * radius);
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GT((grains[a].position - grains[b].position).norm(),
                0.999 * (radius + kinds[grains[b].kind].shape.bounding_radius()));
  }
  EXPECT_LT(top, 1.05 * pour_height(scene, settings));
  EXPECT_GT(top, 0.85 * pour_height(scene, settings));
}

TEST(PourSizes, DependsOnTheSeedAlone) {
  Scene scene = scene_with(kTwo);
  const auto settings = engine_settings(scene, 1.0);
  const auto first = pour(scene, settings, floor_below()), again = pour(scene, settings, floor_below());
  scene.seed = 2;
  const auto other = pour(scene, settings, floor_below());
  std::size_t differ = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].kind, again[k].kind);
    EXPECT_EQ(first[k].position, again[k].position);
    differ += first[k].kind != other[k].kind ? 1U : 0U;
  }
  EXPECT_GT(differ, first.size() / 5);
}

}  // namespace
}  // namespace diefill::process
