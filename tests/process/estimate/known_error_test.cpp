// Errors are told of powders that were measured, not of changed ones.
#include "process/estimate/statements/known_error.h"

#include <gtest/gtest.h>

#include "process/scene/powder/powder_presets.h"
#include "process/scene/powder/unchanged_preset.h"
#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr const char* kSquare = "small_dies/square.toml";
const std::string kGrain = "grain_diameter = \"2.35 mm\"";

TEST(KnownError, IsThatOfThePowderAsPublished) {
  EXPECT_TRUE(known_error(sample(kSquare), false).measured);
  EXPECT_FALSE(known_error(sample(kSquare), true).measured);
  EXPECT_TRUE(
      known_error(sample(kSquare, {{kGrain, kGrain + "\napparent_density = \"3 g/cm^3\""}}), false).measured);
}

TEST(KnownError, IsNotThatOfAPresetWithOtherParameters) {
  for (const char* change : {"friction = 0.5", "work_of_adhesion = \"0.1 J/m^2\"", "model = \"A\"",
                             "reduced_modulus = \"3 MPa\""}) {
    const Scene scene = sample(kSquare, {{kGrain, kGrain + "\n" + change}});
    EXPECT_FALSE(known_error(scene, false).measured) << change;
    EXPECT_FALSE(is_unchanged_preset(scene.powder)) << change;
    EXPECT_NE(discharge_of(scene.powder).applies, discharge_of(powder_preset("Distaloy AE")).applies)
        << change;
  }
}

TEST(KnownError, IsNotThatOfASceneThatChangesWhatActs) {
  const std::vector<Exchanges> changes = {
      {{"\nfriction = 0.15", ""},
       {"[walls]",
        "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"5 MPa\" }\nfriction = { law = "
        "\"Mindlin\", "
        "friction = 0.3, shear_modulus = \"3 MPa\" }\n\n[walls]"}},
      {{"seed = 1", "seed = 1\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-1.62 m/s^2\"]"}},
      {{"[numerics]", "[[step]]\nkind = \"change\"\nfriction = 0.1\n\n[numerics]"}}};
  for (const Exchanges& change : changes) {
    const Scene scene = sample(kSquare, change);
    EXPECT_FALSE(known_error(scene, false).measured) << change.front().second;
    EXPECT_EQ(powder_as_published(scene).name, "custom") << change.front().second;
  }
  EXPECT_EQ(powder_as_published(sample(kSquare)).name, "Distaloy AE");
}

}  // namespace
}  // namespace diefill::process::estimate
