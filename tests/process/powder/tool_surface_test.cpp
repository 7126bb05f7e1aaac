// Tools whose surfaces differ: what a scene says of each is what grains meet there.
#include "process/powder/tool_surface.h"

#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
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

using engine::laws::BierwischNormal;
using engine::laws::CundallFriction;

/// The law of grains of `type` at a tool.
const engine::laws::LawParameters& law_at(const engine::SimulationSettings& settings, std::size_t type,
                                          const engine::WallBodySpec& body) {
  return engine::laws::law_between(settings.contact.pairs, settings.types[type].material, body.material);
}

TEST(ToolSurface, IsThatOfTheWallsUnlessTheToolSaysOtherwise) {
  for (const char* sizes : {"", kTwoSizes}) {
    const Scene scene = scene_with_sticky_shoe(sizes);
    const auto settings = engine_settings(scene, 1.0);
    const auto bodies = wall_bodies(scene, tooling_of(scene));
    ASSERT_EQ(bodies.size(), 2U);
    EXPECT_EQ(settings.types.size(), *sizes == 0 ? 1U : 2U);
    for (std::size_t type = 0; type < settings.types.size(); ++type) {
      const auto &usual = law_at(settings, type, bodies[0]), &sticky = law_at(settings, type, bodies[1]);
      EXPECT_EQ(usual.friction.of<CundallFriction>()->friction, 0.2);
      EXPECT_EQ(sticky.friction.of<CundallFriction>()->friction, 0.4);
      EXPECT_EQ(usual.normal.of<BierwischNormal>()->work_of_adhesion, 0);
      EXPECT_EQ(sticky.normal.of<BierwischNormal>()->work_of_adhesion, 0.01);
      EXPECT_EQ(sticky.normal.of<BierwischNormal>()->reduced_modulus,
                usual.normal.of<BierwischNormal>()->reduced_modulus);
    }
  }
}

/// The scene with Hertz-Mindlin contacts of friction 0.5, and what the shoe adds to them.
Scene scene_with_named_laws(const std::string& of_shoe) {
  static const SceneFolder folder;
  support::SceneTables tables;
  tables.shoe += of_shoe;
  tables.walls += R"(
[contact]
normal = { law = "JKR", modulus = "5 MPa", surface_energy = "0 J/m^2" }
friction = { law = "Mindlin", friction = 0.5, shear_modulus = "1 MPa" }
)";
  return parse_scene(support::scene_text(tables), folder.path() / "scene.toml");
}

TEST(ToolSurface, HasItsOwnFrictionAndAdhesionBesideNamedLaws) {
  const Scene scene = scene_with_named_laws("friction = 0.1\nwork_of_adhesion = \"0.02 J/m^2\"\n");
  const auto settings = engine_settings(scene, 1.0);
  const auto bodies = wall_bodies(scene, tooling_of(scene));
  const auto &usual = law_at(settings, 0, bodies[0]), &own = law_at(settings, 0, bodies[1]);
  EXPECT_EQ(usual.friction.largest_friction(), 0.5);
  EXPECT_EQ(own.friction.largest_friction(), 0.1);
  EXPECT_EQ(usual.normal.of<engine::laws::JkrNormal>()->surface_energy, 0);
  EXPECT_NEAR(own.normal.of<engine::laws::JkrNormal>()->surface_energy,
              0.01 * coarse_graining_factor(scene.powder), 1e-12);
}

TEST(ToolSurface, HasLawsOfItsOwn) {
  const Scene scene = scene_with_named_laws(
      "contact = { friction = { law = \"none\" }, normal = { law = \"Hertz-Mindlin\", modulus = \"9 MPa\" } "
      "}\n");
  const auto settings = engine_settings(scene, 1.0);
  const auto bodies = wall_bodies(scene, tooling_of(scene));
  const auto& own = law_at(settings, 0, bodies[1]);
  EXPECT_EQ(own.friction.largest_friction(), 0);
  ASSERT_NE(own.normal.of<engine::laws::HertzMindlinNormal>(), nullptr);
  EXPECT_EQ(own.normal.of<engine::laws::HertzMindlinNormal>()->modulus, 9e6);
  EXPECT_EQ(law_at(settings, 0, bodies[0]).friction.largest_friction(), 0.5);
}

TEST(ToolSurface, RefusesWhatItsLawHasNot) {
  const auto refusal = [](const std::string& of_shoe) {
    try {
      scene_with_named_laws(of_shoe);
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  EXPECT_NE(refusal("friction = 0.1\ncontact = { friction = { law = \"none\" } }\n")
                .find("tool.friction: found 0.1, friction law \"none\" has no coefficient"),
            std::string::npos);
  EXPECT_NE(
      refusal("work_of_adhesion = \"0.1 J/m^2\"\ncontact = { normal = { law = \"Hertz-Mindlin\", modulus = "
              "\"9 MPa\" } }\n")
          .find("normal law \"Hertz-Mindlin\" has no adhesion"),
      std::string::npos);
  EXPECT_NE(refusal("contact = { fricton = { law = \"none\" } }\n").find("did you mean \"friction\"?"),
            std::string::npos);
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
    engine::Simulation simulation(settings, wall_bodies(scene, tooling));
    simulation.add_grains({engine::NewGrain{.position = {0, 0, 5e-3}}});
    EXPECT_NO_THROW(simulation.step());
  }
}

}  // namespace
}  // namespace diefill::process
