// Scenes that take their powder from a file of its own.
#include <gtest/gtest.h>

#include <string>

#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/powder_file.h"
#include "process/scene/variants.h"
#include "tests/process/fitted_with.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

const std::string kPowderFile = R"([powder]
preset = "ASC100.29 D2"
friction = 0.42
work_of_adhesion = "0.02 J/m^2"
)" + kFittedWith + R"([walls]
friction = 0.2

[calibration]
agrees = true
)";

/// The faultless scene with a powder file in place of its preset.
class PowderFile : public testing::Test {
 protected:
  PowderFile() { write("powder.toml", kPowderFile); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }
  Scene read(const std::string& keys = "file = \"powder.toml\"\ngrain_diameter = \"1.88 mm\"\n") const {
    return read_scene(folder_.write(support::exchanged(
        faultless_scene(), "preset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n", keys)));
  }
  std::string complaint(const std::string& keys = "file = \"powder.toml\"\n") const {
    try {
      read(keys);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no complaint";
  }

  SceneFolder folder_;
};

TEST_F(PowderFile, GivesWhatTheSceneDoesNotGiveItself) {
  const Scene scene = read();
  EXPECT_EQ(scene.powder.friction, 0.42);
  EXPECT_EQ(scene.powder.work_of_adhesion, 0.02);
  EXPECT_EQ(scene.walls.friction, 0.2);
  EXPECT_NEAR(scene.powder.grain_diameter, 1.88e-3, 2e-5);
  EXPECT_EQ(read("file = \"powder.toml\"\nfriction = 0.5\n").powder.friction, 0.5);
}

TEST_F(PowderFile, TheScenesTextStandsAlone) {
  const Scene scene = read();
  EXPECT_EQ(scene.text.find("powder.toml"), std::string::npos);
  const SceneFolder elsewhere;
  const Scene again = read_scene(elsewhere.write(scene.text));
  EXPECT_EQ(again.powder.friction, 0.42);
  EXPECT_EQ(again.walls.friction, 0.2);
}

TEST_F(PowderFile, VariantsAndChangesBuildOnIt) {
  const Scene scene = read();
  SceneChanges changes;
  changes.set = "powder.friction = 0.3\n";
  EXPECT_EQ(changed_scene(scene.text, scene.file, changes).powder.friction, 0.3);
  folder_.write(
      support::exchanged(faultless_scene(), "preset = \"Distaloy AE\"", "file = \"powder.toml\"") +
      "\n[[variant]]\nname = \"a\"\n\n[[variant]]\nname = \"b\"\n[variant.powder]\nfriction = 0.1\n");
  const auto variants = read_variants(folder_.path() / "scene.toml");
  ASSERT_EQ(variants.size(), 2U);
  EXPECT_EQ(variants[0].scene.powder.friction, 0.42);
  EXPECT_EQ(variants[1].scene.powder.friction, 0.1);
  EXPECT_EQ(variants[1].scene.powder.work_of_adhesion, 0.02);
}

TEST_F(PowderFile, OtherWallsAndStiffnessAreWarnedOf) {
  EXPECT_EQ(fitted_with_warning(read()), "");
  const std::string stiff =
      fitted_with_warning(read("file = \"powder.toml\"\nreduced_modulus = \"20 MPa\"\n"));
  EXPECT_NE(stiff.find("reduced modulus 20 MPa instead of 10 MPa"), std::string::npos) << stiff;
  write("powder.toml", support::exchanged(kPowderFile, "wall_sphere_radius = \"0.15 mm\"",
                                          "wall_sphere_radius = \"0.3 mm\""));
  const std::string walls = fitted_with_warning(read());
  EXPECT_NE(walls.find("wall spheres of radius 0.15 mm instead of 0.3 mm"), std::string::npos) << walls;
}

TEST_F(PowderFile, APowderOfAnotherContactLawBringsItsLawAndMayBeGivenAnother) {
  write("powder.toml", R"([powder]
preset = "ASC100.29 A2"

[contact]
normal = { law = "JKR", modulus = "5 MPa", surface_energy = "0.01 J/m^2" }
damping = { law = "restitution", restitution = 0.5 }
friction = { law = "Mindlin", friction = 0.5, shear_modulus = "2 MPa" }
)");
  EXPECT_NE(read("file = \"powder.toml\"\n").contact, nullptr);
}

TEST_F(PowderFile, FaultsAreNamedInTheFileWhereTheyStand) {
  EXPECT_NE(complaint("file = \"none.toml\"\n").find("none.toml"), std::string::npos);
  EXPECT_NE(complaint("file = \"powder.toml\"\npreset = \"Distaloy AE\"\n").find("powder.file gives it"),
            std::string::npos);
  write("powder.toml", support::exchanged(kPowderFile, "friction = 0.42", "frction = 0.42"));
  const std::string key = complaint();
  EXPECT_NE(key.find("powder.toml:3"), std::string::npos) << key;
  EXPECT_NE(key.find("friction"), std::string::npos) << key;
  write("powder.toml", kPowderFile + "\n[pour]\n");
  EXPECT_NE(complaint().find("pour"), std::string::npos);
  write("powder.toml", "friction = ");
  EXPECT_NE(complaint().find("powder.toml:1"), std::string::npos);
}

TEST_F(PowderFile, SectionsOfTheSceneThatAreNoTablesAreRefusedWithTheirPlace) {
  const std::string named =
      support::exchanged(faultless_scene(), "preset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n",
                         "file = \"powder.toml\"\n");
  const std::string without =
      support::exchanged(named, "[walls]\nsphere_radius = \"0.15 mm\"\nspacing = 1.6\n", "");
  const auto refusal = [&](const std::string& text) {
    try {
      read_scene(folder_.write(text));
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string("no complaint");
  };
  for (const auto& [text, found] :
       {std::pair{"walls = 3\n" + without,
                  "scene.toml:1:9: walls: found 3, expected one table: write [walls]"},
        {"contact = 3\n" + named, "scene.toml:1:11: contact: found 3, expected one table: write [contact]"},
        {support::exchanged(named, "[walls]", "[[walls]]"), ": walls: found"},
        {support::exchanged(named, "[powder]", "[[powder]]"), ": powder: found"}}) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(found), std::string::npos) << message;
    EXPECT_NE(message.find("expected one table"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  SceneChanges changes;
  changes.set = "walls = [1]\n";
  try {
    changed_scene(named, folder_.path() / "scene.toml", changes);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("walls: found [1], expected one table"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace diefill::process
