// Variants of a scene: what they change, what they leave alone, and what is said about wrong ones.
#include <gtest/gtest.h>

#include "process/machine/motions/passage.h"
#include "process/scene/variants.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

std::vector<Variant> variants_of(const std::string& tables) {
  const SceneFolder folder;
  return read_variants(folder.write(faultless_scene() + tables));
}

std::string complaint_about(const std::string& tables) {
  try {
    variants_of(tables);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  EXPECT_EQ(message.find('\n'), std::string::npos);
  for (const auto& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\nin " << message;
}

/// Line of the faultless scene with something appended on which the first appended line stands.
int lines_before() {
  const std::string text = faultless_scene();
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SceneChanges, GiveAKeyAgainThatLiesUnderThem) {
  const SceneFolder folder;
  SceneChanges changes;
  changes.under = "powder.\"friction\" = 0.4\npowder.\"work_of_adhesion\" = \"0.002 J/m^2\"\n";
  changes.set = "powder.friction = 0.3\n";
  const Scene scene = changed_scene(faultless_scene(), folder.write(faultless_scene()), changes);
  EXPECT_EQ(scene.powder.friction, 0.3);
  EXPECT_EQ(scene.powder.work_of_adhesion, 0.002);
}

TEST(SceneChanges, FaultsNameTheOptionAndNotTheFile) {
  const SceneFolder folder;
  const auto file = folder.write(faultless_scene());
  const auto complaint = [&](const std::string& set, const std::string& called = "--set") -> std::string {
    try {
      SceneChanges changes;
      changes.set = set;
      changes.source = called;
      changed_scene(faultless_scene(), file, changes);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no complaint";
  };
  EXPECT_TRUE(
      complaint("powder.frction = 1\n").starts_with("--set, change 1: powder.frction: found 1 under"));
  EXPECT_TRUE(complaint("seed = 2\nstep.9.velocity = \"1 m/s\"\n")
                  .starts_with("--set, change 2: step.9: found a table, no [[step]] has this name"));
  EXPECT_TRUE(complaint("step.1.velocity = \"1 kg\"\n", "--vary")
                  .starts_with("--vary, change 1: step.1.velocity: found \"1 kg\""))
      << complaint("step.1.velocity = \"1 kg\"\n", "--vary");
  EXPECT_TRUE(complaint("seed = = 2\n").starts_with("--set:1:")) << complaint("seed = = 2\n");
  EXPECT_EQ(complaint("powder.friction = 0.5\n"), "no complaint");
}

TEST(SceneChanges, FaultsNameKeysAsTheChangeWroteThem) {
  const SceneFolder folder;
  const auto file = folder.write(faultless_scene());
  const std::pair<const char*, const char*> faults[] = {
      {"step.1.velocty = \"1 m/s\"", "step.1.velocty: found \"1 m/s\" under an unknown key"},
      {"step.1 = {velocity = \"1 kg\"}", "step.1.velocity: found \"1 kg\""},
      {"tool.shoe.file = \"none.stl\"", "tool.shoe.file: found \"none.stl\""},
      {"tool.\"shoe\".position = [\"1 mm\", \"2 kg\", \"0 mm\"]", "tool.shoe.position[y]: found \"2 kg\""},
      {"[powder]\nfriction = -1", "powder.friction: found -1"}};
  for (const auto& [change, named] : faults) {
    SceneChanges changes;
    changes.set = change;
    try {
      changed_scene(faultless_scene(), file, changes);
      ADD_FAILURE() << "no complaint about " << change;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string(": ") + named), std::string::npos) << error.what();
    }
  }
}

TEST(Variants, ChangeWhatTheyNameAndNothingElse) {
  const auto variants = variants_of(R"(
[[variant]]
name = "as before"

[[variant]]
name = "slow, 2 passages"
seed = 7
powder.friction = 0.5
step.1.velocity = "0.02 m/s"
step.1.passages = 2
tool.shoe.position = ["40 mm", "0 mm", "0 mm"]
)");
  ASSERT_EQ(variants.size(), 2U);
  const Scene &first = variants[0].scene, &second = variants[1].scene;
  EXPECT_EQ(variants[1].name, "slow, 2 passages");
  EXPECT_EQ(variants[1].folder, "slow__2_passages");
  EXPECT_EQ(first.title, "Narrow ring, one passage: as before");
  EXPECT_EQ(strategy_text(first), "1 passage at 0.2 m/s");
  EXPECT_EQ(strategy_text(second), "2 passages at 0.02 m/s");
  EXPECT_EQ(first.seed, 1U);
  EXPECT_EQ(second.seed, 7U);
  EXPECT_EQ(second.powder.friction, 0.5);
  EXPECT_EQ(second.powder.grain_diameter, first.powder.grain_diameter);
  EXPECT_NEAR(first.tools[1].position[0], 35.4e-3, 1e-12);
  EXPECT_NEAR(second.tools[1].position[0], 40e-3, 1e-12);
  EXPECT_EQ(second.tools[0].position, first.tools[0].position);
}

TEST(Variants, ReplaceWholeListsAndTables) {
  const auto variants = variants_of(R"(
[[variant]]
name = "only waits"
title = "A title of its own"
[[variant.step]]
kind = "wait"
duration = "0.1 s"
[[variant.step]]
kind = "settle"
[variant.measure]
azimuth_bins = 12
)");
  ASSERT_EQ(variants.size(), 1U);
  EXPECT_EQ(variants[0].scene.title, "A title of its own");
  EXPECT_EQ(variants[0].scene.steps.size(), 2U);
  EXPECT_EQ(variants[0].scene.measure.azimuth_bins, 12);
}

TEST(Variants, AStepOfAnotherKindForgetsAllButItsName) {
  const auto variants = variants_of(R"(
[[variant]]
name = "named passage"
step.1.name = "filling"

[[variant]]
name = "waits instead"
step.1 = { kind = "wait", duration = "0.1 s" }

[[variant]]
name = "waits under its name"
step.1 = { kind = "wait", duration = "0.1 s", name = "pause" }

[[variant]]
name = "of the same kind"
step.1 = { kind = "passage", velocity = "0.05 m/s", direction = [-1, 1, 0] }
)");
  ASSERT_EQ(variants.size(), 4U);
  EXPECT_EQ(variants[0].scene.steps[0]->plan.name, "filling");
  EXPECT_EQ(strategy_text(variants[1].scene), "a wait of 0.1 s");
  EXPECT_EQ(variants[2].scene.steps[0]->plan.name, "pause");
  EXPECT_EQ(strategy_text(variants[3].scene), "1 passage at 0.05 m/s");
  const auto& passage = dynamic_cast<const Passage&>(*variants[3].scene.steps[0]);
  EXPECT_TRUE(passage.spec().direction.isApprox(Eigen::Vector3d(-1, 1, 0).normalized()));
}

TEST(Variants, AStepOfAnotherKindKeepsItsName) {
  const SceneFolder folder;
  const std::string scene = faultless_scene() + R"(
[[step]]
kind = "wait"
name = "rest"
duration = "0.1 s"

[[variant]]
name = "settles"
step.rest.kind = "settle"
)";
  const auto variants = read_variants(folder.write(scene));
  ASSERT_EQ(variants.size(), 1U);
  EXPECT_EQ(variants[0].scene.steps.back()->plan.name, "rest");
  EXPECT_TRUE(variants[0].scene.steps.back()->open_ended());
}

TEST(Variants, ASceneWithoutAnyIsComparedAsItIs) {
  const auto variants = variants_of("");
  ASSERT_EQ(variants.size(), 1U);
  EXPECT_EQ(variants[0].folder, "as_it_is");
}

TEST(Variants, AreScenesOfTheirOwn) {
  const SceneFolder folder;
  const auto file =
      folder.write(faultless_scene() + "\n[[variant]]\nname = \"slow\"\nstep.1.velocity = \"0.02 m/s\"\n");
  const auto variant = read_variants(file).front();
  const auto elsewhere = [](const std::filesystem::path& there) {
    return there.filename() == "die.stl" ? "shoe.stl" : "die.stl";
  };
  const Scene alone =
      parse_scene(scene_text_with(variant.scene, 12, elsewhere), folder.path() / "alone.toml");
  EXPECT_EQ(alone.seed, 12U);
  EXPECT_EQ(alone.tools[0].file.filename(), "shoe.stl");
  EXPECT_EQ(alone.tools[1].file.filename(), "die.stl");
  EXPECT_EQ(alone.title, variant.scene.title);
  EXPECT_EQ(strategy_text(alone), "1 passage at 0.02 m/s");
  EXPECT_EQ(alone.powder.grain_diameter, variant.scene.powder.grain_diameter);
  EXPECT_EQ(alone.walls.spacing, variant.scene.walls.spacing);
  // The scene itself runs as if it had no variants.
  EXPECT_EQ(strategy_text(read_scene(file)), "1 passage at 0.2 m/s");
}

TEST(WrongVariants, NameTheLineTheVariantAndTheNearestKey) {
  const auto at = [](int line) { return "scene.toml:" + std::to_string(lines_before() + line) + ':'; };
  const std::string head = "[[variant]]\nname = \"odd\"\n";
  expect_parts(complaint_about(head + "step.1.velocty = \"1 mm/s\"\n"),
               {at(3), "velocty", "did you mean \"velocity\"?", "(in variant \"odd\")"});
  expect_parts(complaint_about(head + "tool.sho.position = [\"1 mm\", \"0 mm\", \"0 mm\"]\n"),
               {at(3), "variant.tool.sho", "no [[tool]] has this name or number", "did you mean \"shoe\"?"});
  expect_parts(complaint_about(head + "step.3.velocity = \"1 mm/s\"\n"),
               {at(3), "no [[step]] has this name or number", "allowed: \"1\""});
  expect_parts(complaint_about(head + "step.1 = 4\n"), {at(3), "found 4", "expected keys to change"});
  expect_parts(complaint_about(head + "pours.fill_height = \"1 mm\"\n"), {at(3), "did you mean \"pour\"?"});
  expect_parts(complaint_about(head + "powder.friction = \"a lot\"\n"),
               {at(3), "powder.friction", "found \"a lot\"", "(in variant \"odd\")"});
  expect_parts(complaint_about(head + "tool.die.file = \"no_such.stl\"\n"), {at(3), "no_such.stl"});
}

TEST(WrongVariants, NeedNamesOfTheirOwn) {
  expect_parts(complaint_about("[[variant]]\nseed = 2\n"), {"variant.name", "a value is required"});
  for (const char* blank : {"", "   "})
    expect_parts(complaint_about(std::string("[[variant]]\nname = \"") + blank + "\"\n"),
                 {"variant.name", "printable characters"});
  for (const char* unseen : {"two\\nlines", "\\u0007", "\\u0085", "\\u2028", "\\u202e"})
    expect_parts(complaint_about(std::string("[[variant]]\nname = \"") + unseen + "\"\n"),
                 {"variant.name", "a text on one line, without line breaks or other control characters"});
  expect_parts(complaint_about("[[variant]]\nname = \"" + std::string(1001, 'n') + "\"\n"),
               {"variant.name", "at most 1000 bytes"});
  expect_parts(complaint_about("[[variant]]\nname = \"a b\"\n[[variant]]\nname = \"a b\"\n"),
               {"variant.name", "\"a b\"", "a unique name"});
  expect_parts(complaint_about("variant = 3\n"), {"variant"});
}

}  // namespace
}  // namespace diefill::process
