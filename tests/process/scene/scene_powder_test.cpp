// Powders of a scene against the published tables (Bierwisch 2009, Tables 4.2, C.4 and C.6).
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "process/scene/powder/powder_presets.h"
#include "process/scene/scene.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// The powder of the faultless scene with its [powder] table exchanged.
PowderSpec powder_spec_of(const std::string& keys) {
  const SceneFolder folder;
  std::string text = faultless_scene();
  const std::string old = "preset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n";
  text.replace(text.find(old), old.size(), keys);
  // Small enough holes for every powder here.
  text.replace(text.find("spacing = 1.6"), 13, "spacing = 1.4");
  return read_scene(folder.write(text)).powder;
}

struct Row {
  const char* preset;
  GrainModel model;
  double friction, adhesion, rolling, adhesion_over_radius;
};

class Presets : public testing::TestWithParam<Row> {};

TEST_P(Presets, HoldThePublishedParameters) {
  const Row& row = GetParam();
  const PowderSpec powder = powder_spec_of("preset = \"" + std::string(row.preset) + "\"\n");
  EXPECT_EQ(powder.name, row.preset);
  EXPECT_EQ(powder.model, row.model);
  EXPECT_EQ(powder.friction, row.friction);
  EXPECT_EQ(powder.work_of_adhesion, row.adhesion);
  EXPECT_EQ(powder.rolling_friction, row.rolling);
  // The table prints w/R with three digits.
  EXPECT_NEAR(powder.work_of_adhesion / powder.sphere_radius, row.adhesion_over_radius,
              6e-4 * row.adhesion_over_radius);
  EXPECT_EQ(powder.grain_mass, 7.63e-8);
  EXPECT_EQ(powder.reduced_modulus, 1e7);
  EXPECT_EQ(powder.damping_over_radius, 1e6);
  EXPECT_EQ(powder.tangential_over_radius, 1e6);
  EXPECT_EQ(powder.air_viscosity, 2e-5);
  EXPECT_DOUBLE_EQ(coarse_graining_factor(powder), 1);
}

INSTANTIATE_TEST_SUITE_P(Powder, Presets,
                         testing::Values(Row{"ASC100.29 initial A", GrainModel::A, 0.25, 0, 0, 0},
                                         Row{"ASC100.29 initial B", GrainModel::B, 0.25, 0, 3.75e-5, 0},
                                         Row{"ASC100.29 initial C", GrainModel::C, 0.25, 0, 0, 0},
                                         Row{"ASC100.29 initial D", GrainModel::D, 0.25, 0, 0, 0},
                                         Row{"ASC100.29 A1", GrainModel::A, 1.0, 1e-2, 0, 66.7},
                                         Row{"ASC100.29 A2", GrainModel::A, 0.3, 0, 0, 0},
                                         Row{"ASC100.29 B1", GrainModel::B, 1.0, 1e-3, 3.75e-4, 6.67},
                                         Row{"ASC100.29 C1", GrainModel::C, 1.0, 0.2, 0, 2247},
                                         Row{"ASC100.29 D1", GrainModel::D, 1.0, 0.15, 0, 1913},
                                         Row{"ASC100.29 D2", GrainModel::D, 1.0, 1e-2, 0, 127.6},
                                         Row{"Distaloy AE", GrainModel::D, 1.0, 5e-3, 0, 63.8}));

TEST(Powder, PresetsAreElevenAndNoneIsListedTwice) {
  const std::vector<std::string> names = preset_names();
  EXPECT_EQ(names.size(), 11U);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 11U);
  EXPECT_THROW(powder_preset("ASC100.29"), std::invalid_argument);
}

TEST(Powder, ApparentDensityIsKnownWherePublishedAndCanBeStated) {
  EXPECT_EQ(powder_preset("ASC100.29 D2").apparent_density, 3000);
  EXPECT_EQ(powder_preset("Distaloy AE").apparent_density, 0);
  const auto powder = powder_spec_of("preset = \"Distaloy AE\"\napparent_density = \"3.05 g/cm^3\"\n");
  EXPECT_DOUBLE_EQ(powder.apparent_density, 3050);
}

TEST(Powder, RadiusAndDiameterFollowTheModel) {
  EXPECT_EQ(powder_preset("ASC100.29 A2").sphere_radius, 1.5e-4);
  EXPECT_EQ(powder_preset("ASC100.29 B1").sphere_radius, 1.5e-4);
  EXPECT_EQ(powder_preset("ASC100.29 C1").sphere_radius, 8.9e-5);
  EXPECT_EQ(powder_preset("ASC100.29 D2").sphere_radius, 7.84e-5);
  EXPECT_DOUBLE_EQ(powder_preset("ASC100.29 A2").grain_diameter, 3.0e-4);
  EXPECT_DOUBLE_EQ(powder_preset("ASC100.29 C1").grain_diameter, 3.56e-4);
  EXPECT_NEAR(powder_preset("ASC100.29 D2").grain_diameter, 4.7e-4, 1e-3 * 4.7e-4);
}

// Table C.6 prints d = 0.47, 0.94, 1.88 mm beside R = 0.0784, 0.1568, 0.3136 mm and m
// = 7.63e-8, 6.104e-7, 4.883e-6 kg.
TEST(Powder, PrintedGrainSizesGiveTheTabulatedRadiiAndMasses) {
  const struct {
    const char* size;
    double factor, radius, mass;
  } rows[] = {{"0.47 mm", 1, 7.84e-5, 7.63e-8},
              {"0.94 mm", 2, 1.568e-4, 6.104e-7},
              {"1.88 mm", 4, 3.136e-4, 4.883e-6}};
  for (const auto& row : rows) {
    const PowderSpec powder =
        powder_spec_of("preset = \"Distaloy AE\"\ngrain_diameter = \"" + std::string(row.size) + "\"\n");
    const double factor = coarse_graining_factor(powder);
    EXPECT_NEAR(factor, row.factor, 1e-12);
    EXPECT_NEAR(factor * powder.sphere_radius, row.radius, 1e-12 * row.radius);
    EXPECT_NEAR(factor * factor * factor * powder.grain_mass, row.mass, 1e-4 * row.mass);
    EXPECT_DOUBLE_EQ(powder.grain_diameter, 6 * factor * powder.sphere_radius);
  }
}

TEST(Powder, EveryPropertyOfAPresetCanBeOverridden) {
  const PowderSpec powder = powder_spec_of(R"(preset = "ASC100.29 B1"
friction = 0.4
work_of_adhesion = "2 mJ/m^2"
rolling_friction = "0.05 mm"
reduced_modulus = "20 MPa"
damping_over_radius = "1e5 Pa s/m"
tangential_over_radius = "2 MPa"
air_viscosity = "0 Pa s"
sphere_radius = "0.2 mm"
grain_mass = "0.2 mg"
)");
  EXPECT_EQ(powder.friction, 0.4);
  EXPECT_DOUBLE_EQ(powder.work_of_adhesion, 2e-3);
  EXPECT_DOUBLE_EQ(powder.rolling_friction, 5e-5);
  EXPECT_DOUBLE_EQ(powder.reduced_modulus, 2e7);
  EXPECT_DOUBLE_EQ(powder.damping_over_radius, 1e5);
  EXPECT_DOUBLE_EQ(powder.tangential_over_radius, 2e6);
  EXPECT_EQ(powder.air_viscosity, 0);
  EXPECT_DOUBLE_EQ(powder.sphere_radius, 2e-4);
  EXPECT_DOUBLE_EQ(powder.grain_mass, 2e-7);
  EXPECT_DOUBLE_EQ(powder.grain_diameter, 4e-4);
}

TEST(Powder, AnotherModelKeepsTheSolidVolumeAndDropsRollingFriction) {
  const PowderSpec powder = powder_spec_of("preset = \"ASC100.29 B1\"\nmodel = \"D\"\n");
  EXPECT_EQ(powder.model, GrainModel::D);
  EXPECT_EQ(powder.sphere_radius, 7.84e-5);
  EXPECT_EQ(powder.rolling_friction, 0);
  // Seven spheres of D against one of B: equal to 0.1 %.
  EXPECT_NEAR(7 * std::pow(powder.sphere_radius, 3) / std::pow(1.5e-4, 3), 1, 1e-3);
}

TEST(Powder, OwnPowderTakesItsExactDiameter) {
  const PowderSpec powder = powder_spec_of(
      "model = \"D\"\nsphere_radius = \"0.1 mm\"\ngrain_mass = \"0.2 mg\"\ngrain_diameter = \"1.2 mm\"\n");
  EXPECT_EQ(powder.name, "custom");
  EXPECT_DOUBLE_EQ(powder.grain_diameter, 1.2e-3);
  EXPECT_DOUBLE_EQ(coarse_graining_factor(powder), 2);
}

}  // namespace
}  // namespace diefill::process
