// Parameters: what they change in a scene, which values are finer, and what is said about wrong ones.
#include <gtest/gtest.h>

#include <set>

#include "process/tradeoff/parameter_registry.h"
#include "process/tradeoff/settings.h"
#include "process/tradeoff/trade_off.h"
#include "process/tradeoff/work_estimate.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

/// A scene in a folder that stays as long as it.
struct KeptScene {
  explicit KeptScene(const std::string& text) : scene(read_scene(folder.write(text))) {}
  SceneFolder folder;
  Scene scene;
};

/// The ring of the tests as a slice of a wide tool.
std::string periodic_scene() {
  return support::exchanged(faultless_scene(), "max_time = \"5 s\"",
                            "max_time = \"5 s\"\nperiodic = { y = \"29 mm\" }");
}

Scene turned(const Scene& scene, const std::string& parameter, const std::string& value) {
  const TriedSetting setting = setting_with(scene, "test", "test", {{parameter_called(parameter), value}});
  EXPECT_EQ(setting.refused, "");
  return setting.variant.scene;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no message";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  EXPECT_EQ(message.find('\n'), std::string::npos);
  for (const auto& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\nin " << message;
}

TEST(ParameterRegistry, EveryParameterHasANameOfItsOwnAndDoesWhatItSays) {
  const KeptScene kept(periodic_scene());
  std::set<std::string> names;
  for (const Parameter& parameter : parameter_registry()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    EXPECT_FALSE(parameter.label.empty() || parameter.sign.empty()) << parameter.name;
    const std::string now = parameter.current(kept.scene);
    EXPECT_FALSE(now.empty()) << parameter.name;
    EXPECT_FALSE(parameter.usual(kept.scene).empty()) << parameter.name;
    for (const std::string& value : parameter.usual(kept.scene)) {
      const TriedSetting setting = setting_with(kept.scene, "test", "test", {{parameter, value}});
      if (!setting.refused.empty()) continue;  // such as a slice of fewer than four grains
      EXPECT_TRUE(same_value(parameter, parameter.current(setting.variant.scene), value))
          << parameter.name << ' ' << value;
    }
  }
}

TEST(ParameterRegistry, ParametersChangeTheirKeysInTheirUnits) {
  const KeptScene kept(faultless_scene());
  EXPECT_NEAR(turned(kept.scene, "grain_diameter", "2.4 mm").powder.grain_diameter, 2.4e-3, 5e-6);
  EXPECT_NEAR(turned(kept.scene, "grain_diameter", "2.4 mm by bierwisch").powder.grain_diameter, 2.4e-3,
              5e-6);
  EXPECT_EQ(turned(kept.scene, "time_step", "0.3").numerics.time_step_fraction, 0.3);
  EXPECT_EQ(turned(kept.scene, "reduced_modulus", "1 MPa").powder.reduced_modulus, 1e6);
  EXPECT_EQ(turned(kept.scene, "grain_model", "A").powder.model, GrainModel::A);
  EXPECT_NEAR(turned(kept.scene, "wall_sphere_radius", "0.1 mm").walls.sphere_radius, 1e-4, 1e-15);
  EXPECT_EQ(turned(kept.scene, "wall_spacing", "1.2").walls.spacing, 1.2);
  EXPECT_NEAR(turned(kept.scene, "powder_height", "12 mm").pour.fill_height, 0.012, 1e-15);
  EXPECT_NEAR(turned(kept.scene, "skin", "0.05 mm").numerics.skin, 5e-5, 1e-15);
  EXPECT_EQ(turned(turned(kept.scene, "skin", "0.05 mm"), "skin", "adaptive").numerics.skin, 0);
}

TEST(ParameterRegistry, AFractionTakesThePlaceOfATimeStepGivenOutright) {
  const KeptScene kept(support::exchanged(faultless_scene(), "max_time", "time_step = \"2 us\"\nmax_time"));
  const Scene scene = turned(kept.scene, "time_step", "0.3");
  EXPECT_FALSE(scene.numerics.time_step);
  EXPECT_EQ(scene.numerics.time_step_fraction, 0.3);
}

TEST(ParameterRegistry, AThinnerSliceTakesThePourAlong) {
  const KeptScene kept(periodic_scene());
  const Scene half = turned(kept.scene, "slice_length", "14.5 mm");
  EXPECT_NEAR(*half.numerics.period[1], 0.0145, 1e-12);
  EXPECT_NEAR(half.pour.lower[1], -0.00725, 1e-12);
  EXPECT_NEAR(half.pour.upper[1], 0.00725, 1e-12);
  EXPECT_EQ(half.pour.lower[0], kept.scene.pour.lower[0]);
  EXPECT_NEAR(work_per_second(half), 0.5 * work_per_second(kept.scene), 0.05 * work_per_second(kept.scene));
  const KeptScene whole(faultless_scene());
  EXPECT_TRUE(parameter_called("slice_length").usual(whole.scene).empty());
  expect_parts(message_of([&] { one_at_a_time(whole.scene, {read_vary("slice_length=9 mm")}, true); }),
               {"--vary slice_length=9 mm", "not periodic"});
}

TEST(ParameterRegistry, AClumpOfTheScenesOwnHasNoOtherModelsToTry) {
  const KeptScene kept(support::exchanged(
      faultless_scene(), "preset = \"Distaloy AE\"\n",
      "spheres = [ { centre = [\"-0.05 mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 mm\" }, { centre = [\"0.05 "
      "mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 mm\" } ]\ngrain_mass = \"5e-8 kg\"\n"));
  ASSERT_EQ(kept.scene.powder.model, GrainModel::clump);
  const Parameter parameter = parameter_called("grain_model");
  EXPECT_TRUE(parameter.usual(kept.scene).empty());
  EXPECT_EQ(parameter.current(kept.scene), "clump");
  for (const ParameterValues& values : usual_parameters(kept.scene))
    EXPECT_NE(values.parameter.name, "grain_model");
  expect_parts(message_of([&] { one_at_a_time(kept.scene, {read_vary("grain_model=A,B")}, true); }),
               {"--vary grain_model=A", "a clump of its own", "leave out this parameter"});
}

TEST(KeyPaths, APathThatBringsACommentAlongIsNoParameter) {
  expect_parts(message_of([] { parameter_called("# powder.friction"); }),
               {"--vary: found \"# powder.friction\"", "which is not a parameter"});
}

TEST(KeyPaths, AnyKeyOfASceneIsAParameter) {
  const KeptScene kept(faultless_scene());
  EXPECT_EQ(strategy_text(turned(kept.scene, "step.1.velocity", "0.1 m/s")), "1 passage at 0.1 m/s");
  EXPECT_FALSE(turned(kept.scene, "economy.drop_spilled", "false").economy.drop_spilled);
  EXPECT_EQ(turned(kept.scene, "powder.friction", "0.4").powder.friction, 0.4);
  EXPECT_NEAR(turned(kept.scene, "tool.shoe.position", R"(["40 mm", "0 mm", "0 mm"])").tools[1].position[0],
              0.04, 1e-15);
  EXPECT_EQ(key_path_parameter("step.1.velocity").current(kept.scene), "0.2 m/s");
  EXPECT_EQ(key_path_parameter("step.1.clearance").current(kept.scene), "not set");
  EXPECT_EQ(key_path_parameter("tool.shoe.role").current(kept.scene), "shoe");
  EXPECT_EQ(key_path_parameter("step.7.velocity").current(kept.scene), "not set");
}

TEST(KeyPaths, SwitchesAreFinerWhenOff) {
  const Parameter parameter = key_path_parameter("economy.sleep");
  EXPECT_EQ(fineness(parameter, "false", "true"), 1);
  EXPECT_EQ(fineness(parameter, "true", "false"), -1);
  EXPECT_EQ(fineness(key_path_parameter("step.1.velocity"), "0.1 m/s", "0.2 m/s"), 0);
}

TEST(Parameters, KnowWhichValuesAreFinerWhateverTheirUnit) {
  const Parameter diameter = parameter_called("grain_diameter");
  EXPECT_EQ(fineness(diameter, "940 um", "1.88 mm"), 1);
  EXPECT_EQ(fineness(diameter, "1.88 mm", "940 um"), -1);
  EXPECT_EQ(fineness(diameter, "1880 um", "1.88 mm"), 0);
  EXPECT_TRUE(same_value(diameter, "1880 um", "1.88 mm"));
  EXPECT_EQ(fineness(parameter_called("reduced_modulus"), "10 MPa", "1e6 Pa"), 1);
  EXPECT_EQ(fineness(parameter_called("grain_model"), "D", "A"), 1);
  EXPECT_EQ(fineness(parameter_called("skin"), "0.1 mm", "0.2 mm"), 0);
}

TEST(Vary, IsReadWithListsAndQuotes) {
  const ParameterValues plain = read_vary(" grain_diameter = 0.94 mm, 1.88 mm ");
  EXPECT_EQ(plain.parameter.name, "grain_diameter");
  EXPECT_EQ(plain.values, (std::vector<std::string>{"0.94 mm", "1.88 mm"}));
  const ParameterValues lists =
      read_vary(R"(tool.shoe.position=["1 mm", "2 mm", "3 mm"],["4 mm", "5 mm", "6 mm"])");
  EXPECT_EQ(lists.values.size(), 2U);
  EXPECT_EQ(read_vary("numerics.periodic={ x = \"1 mm\", y = \"2 mm\" }").values.size(), 1U);
}

TEST(Vary, WrongOnesEndInOneLineThatHelps) {
  expect_parts(message_of([] { read_vary("grain_diameter"); }), {"--vary", "PARAMETER=VALUE"});
  expect_parts(message_of([] { read_vary("grain_diameter=1 mm,"); }), {"a value is empty"});
  expect_parts(message_of([] { read_vary("grain_diametr=1 mm"); }), {"did you mean \"grain_diameter\"?"});
  expect_parts(message_of([] { read_vary("colour=red"); }),
               {"\"colour\"", "grain_diameter", "economy.sleep"});
  const KeptScene kept(faultless_scene());
  const auto settings = [&](const std::string& text) {
    return message_of([&] { one_at_a_time(kept.scene, {read_vary(text)}, true); });
  };
  expect_parts(settings("grain_diameter=5 m"),
               {"--vary grain_diameter=5 m", "powder.grain_diameter", "found \"5 m\""});
  expect_parts(settings("time_step=3"), {"--vary time_step=3", "found 3", "at most 1"});
  expect_parts(settings("step.1.velocty=1 m/s"), {"did you mean \"velocity\"?"});
  expect_parts(settings("step.9.velocity=1 m/s"), {"no [[step]] has this name or number"});
  expect_parts(settings("time_step=0.3,0.3"), {"--vary time_step=0.3", "twice"});
}

TEST(Settings, TurnOneParameterAtATimeFromTheBase) {
  const KeptScene kept(faultless_scene());
  const auto settings = one_at_a_time(
      kept.scene, {read_vary("grain_diameter=1.88 mm,1.4 mm,2.4 mm"), read_vary("grain_model=A")}, true);
  ASSERT_EQ(settings.size(), 4U);  // its own diameter is the base
  EXPECT_EQ(settings[0].name, "base");
  EXPECT_TRUE(settings[0].changes.empty());
  EXPECT_EQ(settings[1].name, "grain_diameter=1.4 mm");
  EXPECT_EQ(settings[1].label, "d 1.4 mm");
  EXPECT_EQ(settings[1].finer, 1);
  EXPECT_EQ(settings[2].finer, -1);
  EXPECT_EQ(settings[3].finer, -1);
  EXPECT_NEAR(settings[3].variant.scene.powder.grain_diameter, kept.scene.powder.grain_diameter, 5e-6);
  // Grains go with d^-3 and steps with 1/d, unless pinching limits the step.
  EXPECT_GT(settings[1].work, 2 * settings[0].work);
  EXPECT_LT(settings[2].work, 0.6 * settings[0].work);
}

TEST(Settings, LeaveTheScenesOwnVariantsAsideAndKeepItsSeed) {
  const KeptScene kept(support::exchanged(faultless_scene(), "seed = 1", "seed = 7") +
                       "\n[[variant]]\nname = \"slow\"\nstep.1.velocity = \"0.02 m/s\"\n");
  const auto settings = one_at_a_time(kept.scene, {read_vary("time_step=0.3")}, true);
  EXPECT_EQ(settings[1].variant.scene.seed, 7U);
  EXPECT_EQ(settings[1].variant.scene.text.find("variant"), std::string::npos);
  EXPECT_EQ(strategy_text(settings[1].variant.scene), "1 passage at 0.2 m/s");
}

TEST(Settings, VariantsAreParametersTurnedTogether) {
  const KeptScene kept(faultless_scene() +
                       "\n[[variant]]\nname = \"shallow and coarse\"\npour.fill_height = \"8 mm\"\n"
                       "powder.grain_diameter = \"2.4 mm\"\n");
  TradeoffOptions options;
  options.variants = true;
  const auto settings = plan_tradeoff(kept.scene, {}, options).settings;
  ASSERT_EQ(settings.size(), 2U);  // no usual parameters beside
  EXPECT_EQ(settings[1].name, "shallow and coarse");
  EXPECT_FALSE(settings[1].changes.empty());  // or it could be taken for the base
  EXPECT_EQ(settings[1].finer, 0);
  EXPECT_NEAR(settings[1].variant.scene.pour.fill_height, 8e-3, 1e-12);
  EXPECT_LT(settings[1].work, settings[0].work);
}

TEST(Settings, VariantsThatAreNoneOrNamedLikeAnotherSettingAreRefused) {
  TradeoffOptions options;
  options.variants = true;
  const auto refusal = [&](const std::string& added) {
    const KeptScene kept(faultless_scene() + added);
    try {
      plan_tradeoff(kept.scene, {}, options);
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("").find("the scene has no variants"), std::string::npos);
  EXPECT_NE(refusal("\n[[variant]]\nname = \"base\"\n").find("name of another setting"), std::string::npos);
}

TEST(Settings, UsualValuesThatASceneRefusesSaySo) {
  const KeptScene kept(periodic_scene());
  // Half as coarse again needs a slice of four grains.
  const auto settings = one_at_a_time(kept.scene, {{parameter_called("slice_length"), {"3 mm"}}}, false);
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_NE(settings[1].refused.find("numerics.periodic.y: found \"3 mm\""), std::string::npos)
      << settings[1].refused;
}

}  // namespace
}  // namespace diefill::process
