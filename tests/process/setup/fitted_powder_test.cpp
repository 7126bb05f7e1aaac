// A powder with other walls or stiffness than it was fitted with is a likely mistake.
#include <gtest/gtest.h>

#include <algorithm>

#include "process/setup/setup_findings.h"
#include "tests/process/fitted_with.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// Whether a scene with this powder and a modulus of its own is warned of it.
bool warned(const std::string& modulus) {
  const SceneFolder folder;
  std::ofstream(folder.path() / "powder.toml") << R"([powder]
preset = "ASC100.29 D2"
)" + kFittedWith;
  const Scene scene = read_scene(
      folder.write(support::exchanged(faultless_scene(), "preset = \"Distaloy AE\"\n",
                                      "file = \"powder.toml\"\nreduced_modulus = \"" + modulus + "\"\n")));
  Tooling tooling;
  tooling.all.include(Eigen::Vector3d(-0.02, -0.02, -0.025));
  tooling.all.include(Eigen::Vector3d(0.02, 0.02, 0.01));
  const auto findings = setup_findings(scene, tooling);
  return std::any_of(findings.begin(), findings.end(), [](const SetupFinding& finding) {
    return finding.words.find("reduced modulus 20 MPa instead of 10 MPa") != std::string::npos;
  });
}

TEST(FittedPowder, WithAnotherStiffnessIsAFindingOfTheSetUp) {
  EXPECT_TRUE(warned("20 MPa"));
  EXPECT_FALSE(warned("10 MPa"));
}

}  // namespace
}  // namespace diefill::process
