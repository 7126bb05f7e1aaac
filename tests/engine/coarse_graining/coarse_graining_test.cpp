// Coarse graining keeps a collision's course over t/d only if damping, tangential stiffness and work of
// adhesion all grow with the grain (Bierwisch 2009, section 3.1, Fig. 3.1).
#include <gtest/gtest.h>

#include <array>

#include "engine/coarse_graining/methods.h"
#include "tests/engine/coarse_graining_collision.h"

namespace diefill::engine {
namespace {

constexpr int kSteps = 2000;

struct EncounterCase {
  PairCollision encounter;
  LeverArm arm;
};

class CoarseGraining : public ::testing::TestWithParam<EncounterCase> {
 protected:
  CollisionCurve at(const coarse_graining::Material& material) const {
    return collide(material, GetParam().encounter, GetParam().arm, kSteps);
  }
  /// Largest difference of energy density and overlap from the curves at d = 0.47 mm.
  double lost(const coarse_graining::Material& material) const {
    const auto fine = at(table_c1()), coarse = at(material);
    return std::max(difference_over_peak(fine.energy_density, coarse.energy_density),
                    difference_over_peak(fine.overlap_over_size, coarse.overlap_over_size));
  }
};

TEST_P(CoarseGraining, CurvesCollapseWhenAllIsScaled) {
  const auto fine = at(table_c1());
  EXPECT_GT(*std::max_element(fine.overlap_over_size.begin(), fine.overlap_over_size.end()), 1e-3);
  for (const double scale : {2.0, 3.0, 4.0}) {
    const double difference = lost(coarse_graining::bierwisch(table_c1(), scale));
    EXPECT_LT(difference, 1e-6);
  }
}

TEST_P(CoarseGraining, CurvesSpreadWithFixedDamping) {
  for (const double scale : {2.0, 4.0}) {
    auto material = coarse_graining::bierwisch(table_c1(), scale);
    material.damping = table_c1().damping;
    EXPECT_GT(lost(material), 0.02);
  }
}

TEST_P(CoarseGraining, CurvesSpreadWithFixedAdhesion) {
  for (const double scale : {2.0, 4.0}) {
    auto material = coarse_graining::bierwisch(table_c1(), scale);
    material.work_of_adhesion = table_c1().work_of_adhesion;
    EXPECT_GT(lost(material), 0.02);
  }
}

TEST_P(CoarseGraining, CurvesSpreadWithFixedTangentialSpringUnlessHeadOn) {
  for (const double scale : {2.0, 4.0}) {
    auto material = coarse_graining::bierwisch(table_c1(), scale);
    material.tangential = table_c1().tangential;
    if (GetParam().encounter == PairCollision::tip_to_tip) {
      EXPECT_LT(lost(material), 1e-6);
    } else {
      EXPECT_GT(lost(material), 0.02);
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<EncounterCase>& instance) {
  const std::array<const char*, 3> names = {"TipToTip", "Turned", "Oblique"};
  return std::string(names[static_cast<std::size_t>(instance.param.encounter)]) +
         (instance.param.arm == LeverArm::center ? "Center" : "Contact");
}

INSTANTIATE_TEST_SUITE_P(Encounters, CoarseGraining,
                         ::testing::Values(EncounterCase{PairCollision::tip_to_tip, LeverArm::center},
                                           EncounterCase{PairCollision::turned, LeverArm::center},
                                           EncounterCase{PairCollision::turned, LeverArm::contact},
                                           EncounterCase{PairCollision::oblique, LeverArm::center},
                                           EncounterCase{PairCollision::oblique, LeverArm::contact}),
                         name_of);

TEST(CoarseGrainingRule, OfBierwischAndThakurIsOneFunction) {
  const auto* hertz = coarse_graining::parameter_rule("bierwisch");
  const auto* linear = coarse_graining::parameter_rule("Thakur");
  ASSERT_TRUE(hertz && linear);
  EXPECT_EQ(hertz->scaled, linear->scaled);
}

TEST(CoarseGrainingRule, ScalesWhatTheThesisScales) {
  auto fine = table_c1();
  fine.rolling_friction = 3.75e-5;
  fine.air_viscosity = 2e-5;
  const auto coarse = coarse_graining::bierwisch(fine, 2);
  EXPECT_DOUBLE_EQ(coarse.sphere_radius, 1.568e-4);
  EXPECT_DOUBLE_EQ(coarse.grain_mass, 8 * fine.grain_mass);
  EXPECT_DOUBLE_EQ(coarse.reduced_modulus, fine.reduced_modulus);
  EXPECT_DOUBLE_EQ(coarse.friction, fine.friction);
  for (const auto member :
       {&coarse_graining::Material::damping, &coarse_graining::Material::tangential,
        &coarse_graining::Material::work_of_adhesion, &coarse_graining::Material::rolling_friction,
        &coarse_graining::Material::air_viscosity})
    EXPECT_DOUBLE_EQ(coarse.*member, 2 * fine.*member);
}

}  // namespace
}  // namespace diefill::engine
