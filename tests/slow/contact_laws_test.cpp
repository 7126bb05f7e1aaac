// No law that [contact] can name gains energy in a deep bed that rests, is shaken and runs out for long:
// every part by itself and every two that go together, at the step that the program chooses.
#include <gtest/gtest.h>

#include "engine/numerics/out_of_range.h"
#include "tests/support/registered_laws.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/worked_bed.h"

namespace diefill::process {
namespace {

void expect_no_gain(const std::vector<support::RegisteredLaw>& laws) {
  constexpr double kImpact = 1.2;  // m/s, what grains of the bed fall at
  constexpr double kMax = 0.015, kMaxAtRest = 0.002;
  const support::BedWork deep{.across = 6, .layers = 10, .pour = 0.3, .shake = 0.2, .discharge = 0.1};
  for (const auto& law : laws) {
    SCOPED_TRACE(law.contact);
    try {
      const auto gained = support::gained_by(engine_settings(law.scene, kImpact), deep);
      EXPECT_LT(gained.poured, kMax);
      EXPECT_LT(gained.at_rest, kMaxAtRest);
      EXPECT_LT(gained.shaken, kMax);
      EXPECT_LT(gained.discharged, kMax);
    } catch (const engine::OutOfRange& reason) {
      ADD_FAILURE() << reason.what();
    }
  }
}

TEST(ContactLawsInADeepBed, GainNoEnergySinglyAndInPairs) {
  const support::TemporaryFolder folder;
  for (const char* name : {"die.stl", "shoe.stl"}) folder.write(name, "");
  const auto file = folder.path() / "scene.toml";
  expect_no_gain(support::laws_singly(file));
  expect_no_gain(support::laws_in_pairs(file));
}

}  // namespace
}  // namespace diefill::process
