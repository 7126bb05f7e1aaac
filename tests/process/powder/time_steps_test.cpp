// Which steps of its own a scene may name: none that contacts of its damping are not stable at.
#include "process/powder/time_steps.h"

#include <gtest/gtest.h>

#include "engine/limits/time_step.h"
#include "process/input/scene_error.h"
#include "process/powder/material.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

constexpr double kImpact = 0.7;  // m/s

/// The default powder with this damping over the sphere radius (Pa s/m).
Scene damped(double damping) {
  Scene scene;
  scene.file = "scene.toml";
  scene.powder.damping_over_radius = damping;
  return scene;
}

/// A powder of springs and dampers whose strength does not depend on the overlap.
Scene overdamped() {
  const std::string tool = "[[tool]]\nname = \"die\"";
  const std::string contact =
      "[contact]\nnormal = { law = \"linear\", stiffness = \"500 N/m\" }\n"
      "damping = { law = \"linear restitution\", restitution = 0.001 }\n\n";
  const SceneFolder folder;
  return read_scene(folder.write(support::exchanged(faultless_scene(), tool, contact + tool)));
}

/// s, the limits of a scene's steps.
struct StepLimits {
  double critical, lasting;
};
StepLimits limits_of(const Scene& scene) {
  const auto settings = engine_settings(scene, kImpact);
  return {critical_time_step(settings, kImpact), lasting_contact_time_step(settings, kImpact)};
}

/// s, the step that the scene gets.
double step_of(const Scene& scene) {
  return engine_settings(scene, kImpact).time_step;
}

/// Expects that the scene is refused in one line that holds all of `parts`.
void expect_refusal(const Scene& scene, const std::vector<std::string>& parts) {
  try {
    ADD_FAILURE() << "taken with a step of " << step_of(scene) << " s";
  } catch (const SceneError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    for (const auto& part : parts) EXPECT_NE(line.find(part), std::string::npos) << line;
  }
}

TEST(OwnTimeStep, IsRefusedFromWhereLastingContactsAreUnstableOn) {
  Scene scene = overdamped();
  const auto [critical, lasting] = limits_of(scene);
  ASSERT_LT(lasting, 0.7 * critical);
  scene.numerics.time_step = 0.99 * lasting;
  EXPECT_EQ(step_of(scene), *scene.numerics.time_step);
  scene.numerics.time_step = 0.5 * (lasting + critical);
  expect_refusal(scene, {"numerics.time_step: found ", "not below", "lower the damping"});
  scene.numerics.time_step = 2 * critical;
  expect_refusal(scene, {"above the critical step", "the limit of its damping"});
}

TEST(OwnTimeStep, IsRefusedAsAShareOfTheCriticalOneLikewise) {
  Scene scene = overdamped();
  const auto [critical, lasting] = limits_of(scene);
  scene.numerics.time_step_fraction = 0.99 * lasting / critical;
  EXPECT_EQ(step_of(scene), scene.numerics.time_step_fraction * critical);
  scene.numerics.time_step_fraction = 1.01 * lasting / critical;
  expect_refusal(scene, {"numerics.time_step_fraction: found 0.", "not below", "lower the damping"});
}

TEST(OwnTimeStep, MayBeUpToTheCriticalOneWithoutDamping) {
  Scene scene = damped(0);
  scene.numerics.time_step = 0.99 * limits_of(scene).critical;
  EXPECT_EQ(step_of(scene), *scene.numerics.time_step);
  scene.numerics.time_step = 1.01 * limits_of(damped(0)).critical;
  expect_refusal(scene, {"above the critical step", "reduce it or remove the key"});
}

TEST(OwnTimeStep, OfTheProgramIsAFifthOfTheCriticalOneAndBelowThatOfLastingContacts) {
  for (const double damping : {0.0, 1e4, 1e6, 1e8}) {
    const Scene scene = damped(damping);
    const auto [critical, lasting] = limits_of(scene);
    EXPECT_EQ(step_of(scene), engine::kDefaultTimeStepFraction * critical);
    EXPECT_LT(step_of(scene), 0.5 * lasting);
  }
}

}  // namespace
}  // namespace diefill::process
