// No law that [contact] can name gains energy at the step that the program chooses: each part by itself and
// every two that go together, poured, shaken and discharged.
#include <gtest/gtest.h>

#include "engine/out_of_range.h"
#include "tests/process/scene_files.h"
#include "tests/support/registered_laws.h"
#include "tests/support/worked_bed.h"

namespace diefill::process {
namespace {

constexpr double kImpact = 0.7;  // m/s, what grains of the bed fall at

/// Of the energy turned over (engine::HealthLimits::comfortable_energy_error).
constexpr double kMost = 0.01;

void expect_no_gain(const std::vector<support::RegisteredLaw>& laws) {
  for (const auto& law : laws) {
    SCOPED_TRACE(law.contact);
    try {
      const auto gained = support::gained_by(engine_settings(law.scene, kImpact), {});
      EXPECT_LT(gained.poured, kMost);
      EXPECT_LT(gained.shaken, kMost);
      EXPECT_LT(gained.discharged, kMost);
    } catch (const engine::OutOfRange& reason) {
      ADD_FAILURE() << reason.what();
    }
  }
}

TEST(ContactLaws, GainNoEnergySingly) {
  const SceneFolder folder;
  const auto laws = support::laws_singly(folder.path() / "scene.toml");
  std::size_t parts = 0;
  for (const auto& kind : support::registered_parts()) parts += kind.examples.size();
  EXPECT_GT(laws.size() + support::kKindsOfParts, parts);  // what completes the first serves the others too
  expect_no_gain(laws);
}

TEST(ContactLaws, GainNoEnergyInPairs) {
  const SceneFolder folder;
  expect_no_gain(support::laws_in_pairs(folder.path() / "scene.toml"));
}

}  // namespace
}  // namespace diefill::process
