// Springs of the normal direction: closed forms, energies as integrals of forces, stiffness as their slope.
#include "engine/laws/contact_law.h"
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kRadius = 2.5e-4;

TEST(PairPropertiesOfLaws, AreReducedAlsoForWalls) {
  const auto pair = spheres(1e-3, 3e-3);
  EXPECT_DOUBLE_EQ(pair.effective_radius(), 0.75e-3);
  EXPECT_DOUBLE_EQ(pair.effective_mass(), pair.mass_i * pair.mass_j / (pair.mass_i + pair.mass_j));
  const auto wall = sphere_on_wall(1e-3);
  EXPECT_DOUBLE_EQ(wall.effective_radius(), 1e-3);
  EXPECT_DOUBLE_EQ(wall.effective_mass(), wall.mass_i);
  EXPECT_DOUBLE_EQ(wall.effective_inertia(), 0.4 * wall.mass_i * 1e-6);
  EXPECT_TRUE(wall.with_wall());
  const PairProperties wall_sphere{1e-3, 5e-4, 1e-6, kInfinite};
  EXPECT_DOUBLE_EQ(wall_sphere.effective_radius(), 1e-3 / 3);
  EXPECT_DOUBLE_EQ(wall_sphere.effective_mass(), 1e-6);
  EXPECT_TRUE(wall_sphere.with_wall());
}

TEST(BierwischNormalPart, IsTheEnginesLaw) {
  const auto pair = spheres(7.84e-5, 1.2e-4);
  const BierwischNormal part({.reduced_modulus = 1e7, .work_of_adhesion = 0.01}, pair);
  const ContactLaw<HertzianCohesion, NoFriction> law(
      ContactParameters{.reduced_modulus = 1e7, .work_of_adhesion = 0.01}, pair.effective_radius());
  for (const double overlap : {1e-8, 1e-7, 1e-6}) {
    const auto expected = law.normal(overlap, std::sqrt(overlap), 0);
    const auto found = part.force(overlap, std::sqrt(overlap), nullptr);
    EXPECT_DOUBLE_EQ(found.force, expected.total());
    EXPECT_DOUBLE_EQ(found.limit, expected.elastic);
  }
}

TEST(BierwischNormalPart, IsHertzOfHalfTheReducedModulus) {
  const auto pair = spheres(kRadius, kRadius);
  const BierwischNormal one({.reduced_modulus = 1e7}, pair);
  const HertzMindlinNormal other({.modulus = 0.5e7}, pair);
  EXPECT_NEAR(one.force(1e-6, 1e-3, nullptr).force, other.force(1e-6, 1e-3, nullptr).force, 1e-18);
}

TEST(HertzMindlinNormalPart, HasHusStiffness) {
  // Equal spheres: k_n = sqrt(2 r) E / (3 (1 - nu^2)) (Hu 2024, Eq. 2.22).
  const double young = 1e7, poisson = 0.3;
  const double modulus = contact_modulus(young, poisson, young, poisson);
  EXPECT_NEAR(modulus, 5.49451e6, 5);
  EXPECT_NEAR(contact_shear_modulus(young, poisson, young, poisson), 1.13122e6, 5);
  const HertzMindlinNormal part({.modulus = modulus}, spheres(kRadius, kRadius));
  const double expected = std::sqrt(2 * kRadius) * young / (3 * (1 - poisson * poisson));
  EXPECT_NEAR(part.force(4e-6, 2e-3, nullptr).force, expected * 8e-9, 1e-12 * expected * 8e-9);
}

/// Energy is the integral of the force and stiffness its slope, at overlap h.
template <class Part>
void expect_consistent(const Part& part, double h, bool slope_is_stiffness = true) {
  const auto force = [&](double overlap) { return part.force(overlap, std::sqrt(overlap), nullptr).force; };
  const double energy = integral(force, 0, h);
  EXPECT_NEAR(part.energy(h, nullptr), energy, 1e-9 * std::abs(energy)) << h;
  if (!slope_is_stiffness) return;
  const double slope = (force(h * 1.00001) - force(h * 0.99999)) / (2e-5 * h);
  EXPECT_NEAR(part.stiffness(h, nullptr), slope, 1e-7 * std::abs(slope)) << h;
}

TEST(NormalParts, EnergyIsIntegralAndStiffnessSlope) {
  const auto pair = spheres(kRadius, 3 * kRadius);
  for (const double h : {1e-8, 1e-7, 1e-6, 1e-5}) {
    expect_consistent(BierwischNormal({}, pair), h);
    expect_consistent(BierwischNormal({.work_of_adhesion = 0.1}, pair), h, false);
    expect_consistent(HertzMindlinNormal({}, pair), h);
    expect_consistent(LinearNormal({}, pair), h);
    expect_consistent(JkrNormal({.surface_energy = 0.2}, pair), h);
    expect_consistent(JkrNormal({.surface_energy = 0}, pair), h);
  }
}

}  // namespace
}  // namespace diefill::engine::laws
