// Tools whose surfaces differ: what a scene says of each is what grains meet there.
#include "process/powder/tool_surface.h"

#include <gtest/gtest.h>

#include "process/powder/material.h"
#include "process/tooling/wall_bodies.h"
#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"

namespace diefill::process {
namespace {

constexpr const char* kTwoSizes =
    "sizes = { distribution = \"classes\", classes = [{ diameter = \"2.1 mm\", share = 0.7 }, { diameter = "
    "\"1.4 mm\", share = 0.3 }] }";

/// The shoe slides at 0.4 and sticks; the die is as [walls] says, 0.2 and no adhesion.
Scene scene_with_sticky_shoe(const std::string& sizes = "") {
  static const SceneFolder folder;
  support::SceneTables tables;
  tables.walls += "friction = 0.2\n";
  tables.shoe += "friction = 0.4\nwork_of_adhesion = \"0.01 J/m^2\"\n";
  std::string text = support::scene_text(tables);
  if (!sizes.empty()) text = support::exchanged(text, "grain_diameter = \"1.88 mm\"", sizes);
  return parse_scene(text, folder.path() / "scene.toml");
}

Tooling tooling_of(const Scene& scene) {
  Tooling tooling;
  for (const ToolSpec& spec : scene.tools) tooling.tools.emplace_back().spec = spec;
  return tooling;
}

TEST(ToolSurface, IsThatOfTheWallsUnlessTheToolSaysOtherwise) {
  const Scene scene = scene_with_sticky_shoe();
  const auto settings = engine_settings(scene, 1.0);
  const auto bodies = wall_bodies(scene, tooling_of(scene), settings);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_FALSE(bodies[0].contact.has_value());
  EXPECT_EQ(settings.wall_contact.friction, 0.2);
  ASSERT_TRUE(bodies[1].contact.has_value());
  EXPECT_EQ(bodies[1].contact->friction, 0.4);
  EXPECT_EQ(bodies[1].contact->work_of_adhesion, 0.01);
  EXPECT_EQ(bodies[1].contact->reduced_modulus, settings.wall_contact.reduced_modulus);
}

TEST(ToolSurface, IsAMaterialOfItsOwnForGrainsOfSeveralSizes) {
  const Scene scene = scene_with_sticky_shoe(kTwoSizes);
  const auto settings = engine_settings(scene, 1.0);
  ASSERT_TRUE(settings.mix);
  const auto bodies = wall_bodies(scene, tooling_of(scene), settings);
  EXPECT_FALSE(bodies[1].contact.has_value());
  EXPECT_EQ(bodies[0].material, kWallMaterial);
  for (const auto& kind : settings.mix->kinds) {
    const auto& usual = engine::laws::law_between(settings.mix->laws, kind.material, bodies[0].material);
    const auto& sticky = engine::laws::law_between(settings.mix->laws, kind.material, bodies[1].material);
    EXPECT_EQ(std::get<engine::laws::CundallFriction::Parameters>(usual.friction.choice).friction, 0.2);
    EXPECT_EQ(std::get<engine::laws::CundallFriction::Parameters>(sticky.friction.choice).friction, 0.4);
    EXPECT_EQ(std::get<engine::laws::BierwischNormal::Parameters>(sticky.normal.choice).work_of_adhesion,
              0.01);
  }
}

TEST(ToolSurface, IsRefusedBesideNamedLaws) {
  const SceneFolder folder;
  support::SceneTables tables;
  tables.shoe += "friction = 0.4\n";
  tables.walls += "\n[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\" }\n";
  try {
    parse_scene(support::scene_text(tables), folder.path() / "scene.toml");
    FAIL() << "taken";
  } catch (const SceneError& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("tool.friction: found 0.4, [contact] in line"), std::string::npos) << words;
  }
}

TEST(ToolSurface, StandsInTheWayOfNoSimulation) {
  for (const char* sizes : {"", kTwoSizes}) {
    const Scene scene = scene_with_sticky_shoe(sizes);
    const auto settings = engine_settings(scene, 1.0);
    auto tooling = tooling_of(scene);
    for (Tool& tool : tooling.tools) {
      tool.spheres.radius = 1.5e-4;
      tool.spheres.centres = {{0, 0, 0}};
    }
    engine::Simulation simulation(settings, wall_bodies(scene, tooling, settings));
    simulation.add_grains({engine::NewGrain{.position = {0, 0, 5e-3}}});
    EXPECT_NO_THROW(simulation.step());
  }
}

}  // namespace
}  // namespace diefill::process
