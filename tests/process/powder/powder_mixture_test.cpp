// Several powders in one scene: shares, order of pouring, and the laws between them.
#include "process/powder/powder_mixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/machine/actions/powder_change.h"
#include "process/powder/changed_scene.h"
#include "process/powder/material.h"
#include "process/setup/pour.h"
#include "process/tooling/tooling.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

constexpr const char* kCopper =
    "[[other_powder]]\nname = \"copper\"\nshare = 0.25\nmodel = \"A\"\nsphere_radius = \"0.1 "
    "mm\"\ngrain_mass = \"2.6e-8 kg\"\nreduced_modulus = \"30 MPa\"\nfriction = 0.5\nwork_of_adhesion = "
    "\"0.04 "
    "J/m^2\"\n\n";

/// A scene with `tables` in front of its tools and `powder` among the keys of its powder.
Scene scene_with(const std::string& tables, const std::string& powder = "") {
  const SceneFolder folder;
  std::string text = faultless_scene();
  text.insert(text.find("preset = "), powder);
  text.insert(text.find("[[tool]]"), tables);
  return read_scene(folder.write(text));
}

TEST(PowderMixture, HasGrainsByTheMassesOfItsPowders) {
  const Scene scene = scene_with(kCopper);
  const auto shares = number_shares(scene);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_NEAR(shares[0].number_share + shares[1].number_share, 1, 1e-12);
  const auto types = particle_types(scene);
  const double first = shares[0].number_share * types[0].shape.mass,
               second = shares[1].number_share * types[1].shape.mass;
  EXPECT_NEAR(second / (first + second), 0.25, 1e-12);
  EXPECT_NEAR(mean_of_mixture(scene).mass, first + second, 1e-12 * first);
  Tooling everywhere;  // tools below all of the pour box
  everywhere.standing.include(Eigen::Vector3d::Constant(-1));
  everywhere.standing.include(Eigen::Vector3d::Constant(1));
  const auto poured = pour(scene, engine_settings(scene, 1.0), everywhere);
  double mass[2] = {};
  for (const auto& grain : poured) mass[grain.kind] += types[grain.kind].shape.mass;
  EXPECT_EQ(poured.size(), grains_to_pour(scene));
  EXPECT_NEAR(mass[1] / (mass[0] + mass[1]), 0.25, types[0].shape.mass / (mass[0] + mass[1]));
}

TEST(PowderMixture, PoursLayersFromTheFloorUp) {
  Scene scene = scene_with(kCopper);
  scene.pour.layers = {{1, 0.4}, {0, 0.6}};
  const auto types = types_to_pour(scene, grains_to_pour(scene));
  const auto change = std::find(types.begin(), types.end(), 0);
  EXPECT_TRUE(std::all_of(types.begin(), change, [](auto type) { return type == 1; }));
  EXPECT_TRUE(std::all_of(change, types.end(), [](auto type) { return type == 0; }));
  // As thick as the shares of the height say, each at its own solid fraction.
  const auto shapes = particle_types(scene);
  const auto height = [&](std::size_t powder, auto grains) {
    return static_cast<double>(grains) * shapes[powder].shape.solid_volume /
           expected_solid_fraction(scene_of_powder(scene, powder));
  };
  const double lower = height(1, change - types.begin()), upper = height(0, types.end() - change);
  EXPECT_NEAR(lower / (lower + upper), 0.4, 0.01);
}

TEST(PowderMixture, HasMeansBetweenPowdersUnlessThePairSaysOtherwise) {
  const Scene means = scene_with(kCopper, "work_of_adhesion = \"0.01 J/m^2\"\n");
  const PowderSpec& pair = means.powder_pairs.at(0).powder;
  const PowderSpec &first = means.powder, &second = means.other_powders[0].powder;
  EXPECT_DOUBLE_EQ(1 / pair.reduced_modulus, 0.5 / first.reduced_modulus + 0.5 / second.reduced_modulus);
  EXPECT_DOUBLE_EQ(pair.friction, 0.5 * (first.friction + second.friction));
  EXPECT_DOUBLE_EQ(pair.work_of_adhesion, std::sqrt(0.01 * 0.04));
  const Scene named = scene_with(std::string(kCopper) + "[[powder_pair]]\npowders = [\"copper\", \"" +
                                 first.label + "\"]\nfriction = 0.9\n\n");
  EXPECT_DOUBLE_EQ(named.powder_pairs[0].powder.friction, 0.9);
  const auto contact = contact_laws(named, 1e-6);
  const auto materials = particle_types(named);
  EXPECT_DOUBLE_EQ(contact.between(materials[0].material, materials[1].material).friction.largest_friction(),
                   0.9);
  EXPECT_DOUBLE_EQ(contact.between(materials[1].material, materials[1].material).friction.largest_friction(),
                   0.5);
}

TEST(PowderMixture, OfTwoEqualPowdersHasTheLawOfOne) {
  const Scene one = scene_with("");
  std::string same = "[[other_powder]]\nname = \"same\"\nshare = 0.5\n";
  const std::string text = one.text;
  const std::size_t from = text.find("preset = ");
  same += text.substr(from, text.find("\n[", from) - from) + "\n\n";
  const Scene two = scene_with(same);
  const auto alone = contact_laws(one, 1e-6), both = contact_laws(two, 1e-6);
  const auto materials = particle_types(two);
  const auto& own = alone.between(engine::kPowderMaterial, engine::kPowderMaterial);
  const auto& pair = both.between(materials[0].material, materials[1].material);
  EXPECT_DOUBLE_EQ(pair.normal.hertzian_modulus(), own.normal.hertzian_modulus());
  EXPECT_DOUBLE_EQ(pair.friction.largest_friction(), own.friction.largest_friction());
}

TEST(PowderMixture, ChangesInStepsReachAllPowders) {
  const Scene scene = scene_with(kCopper);
  PowderChange change;
  change.friction = 0.7;
  change.wall_friction = 0.05;
  const Scene changed = changed_scene(scene, change);
  for (const auto& pair : contact_laws(changed, 1e-6).pairs)
    EXPECT_DOUBLE_EQ(
        pair.law.friction.largest_friction(),
        pair.first == engine::kWallMaterial || pair.second == engine::kWallMaterial ? 0.05 : 0.7);
}

}  // namespace
}  // namespace diefill::process
