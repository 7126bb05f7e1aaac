// No law that [contact] can name gains energy at the step that the program chooses: each part by itself and
// every two that go together, poured, shaken and discharged.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/numerics/out_of_range.h"
#include "tests/process/scene_files.h"
#include "tests/support/registered_laws.h"
#include "tests/support/worked_bed.h"

namespace diefill::process {
namespace {

constexpr double kImpact = 0.7;  // m/s, what grains of the bed fall at

/// Of the energy exchanged: impacts, a few dozen steps each, are booked to about 1 %, beds at rest exactly.
constexpr double kMax = 0.015, kMaxAtRest = 0.002;

void expect_no_gain(const std::vector<support::RegisteredLaw>& laws) {
  for (const auto& law : laws) {
    SCOPED_TRACE(law.contact);
    try {
      const auto gained = support::gained_by(engine_settings(law.scene, kImpact), {});
      EXPECT_LT(gained.poured, kMax);
      EXPECT_LT(gained.at_rest, kMaxAtRest);
      EXPECT_LT(gained.shaken, kMax);
      EXPECT_LT(gained.discharged, kMax);
    } catch (const engine::OutOfRange& reason) {
      ADD_FAILURE() << reason.what();
    }
  }
}

TEST(ContactLaws, GainNoEnergySingly) {
  const SceneFolder folder;
  const auto laws = support::laws_singly(folder.path() / "scene.toml");
  for (const auto& kind : support::registered_parts())
    for (const auto& example : kind.examples)
      EXPECT_TRUE(std::any_of(laws.begin(), laws.end(), [&](const auto& law) {
        return law.contact.find(kind.kind + " = " + example) != std::string::npos;
      })) << example;
  expect_no_gain(laws);
}

TEST(ContactLaws, GainNoEnergyInPairs) {
  const SceneFolder folder;
  expect_no_gain(support::laws_in_pairs(folder.path() / "scene.toml"));
}

}  // namespace
}  // namespace diefill::process
