// The documents agree with the reader: every key is explained, every preset listed, every sample scene
// readable.
#include <gtest/gtest.h>

#include "process/calibration/calibration_file.h"
#include "process/machine/step_registry.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/scene.h"
#include "process/scene/variants.h"
#include "project_paths.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

using support::contents;

const std::filesystem::path kSource = DIEFILL_SOURCE_DIR;

/// The keys that the reader offers where it finds one that it does not know, for a table header and what it
/// needs.
std::vector<std::string> keys_offered(const std::string& scene) {
  const SceneFolder folder;
  try {
    read_scene(folder.write(scene));
  } catch (const SceneError& error) {
    const std::string message = error.what(), before = "the allowed keys are ";
    const std::size_t start = message.find(before);
    if (start == std::string::npos) return {};
    std::vector<std::string> keys(1);
    for (const char letter : message.substr(start + before.size())) {
      if (letter == ',') {
        keys.emplace_back();
      } else if (letter != ' ') {
        keys.back() += letter;
      }
    }
    return keys;
  }
  return {};
}

/// As a key in a table, or as a heading such as `[pour]` or `[[measure.section]]`.
bool explained(const std::string& readme, const std::string& key) {
  return readme.find('`' + key + '`') != std::string::npos || readme.find(key + "]") != std::string::npos;
}

TEST(SceneReadme, ExplainsEveryKeyThatTheReaderAsksFor) {
  const std::string readme = contents(kSource / "process/scene/README.md");
  const std::string stranger = "\nqqqqqqqqqqqq = 1\n";
  std::size_t checked = 0;
  for (const char* header :
       {"seed = 1", "preset = \"Distaloy AE\"", "spacing = 1.6", "role = \"die\"", "fill_height = \"24 mm\"",
        "direction = \"-x\"", "max_time = \"5 s\"", "sleep = false", "fill_plane = \"0 mm\""}) {
    std::string text = faultless_scene() + "\n[economy]\nsleep = false\n";
    text.replace(text.find(header), std::string(header).size(), header + stranger);
    const auto keys = keys_offered(text);
    EXPECT_FALSE(keys.empty()) << header;
    for (const std::string& key : keys) {
      EXPECT_TRUE(explained(readme, key)) << "process/scene/README.md does not explain " << key;
      ++checked;
    }
  }
  EXPECT_GT(checked, 50U);
}

TEST(SceneReadme, ListsEveryPresetAndKindOfStep) {
  const std::string readme = contents(kSource / "process/scene/README.md");
  for (const std::string& name : preset_names())
    EXPECT_NE(readme.find('`' + name + '`'), std::string::npos) << name;
  for (const auto& [kind, factory] : step_kinds()) {
    EXPECT_NE(readme.find("`kind = \"" + kind + "\"`"), std::string::npos) << kind;
  }
}

/// A scene with the powder of this file: the bed of fine powder with its own powder taken out.
std::string scene_with_powder_of(const std::filesystem::path& file) {
  std::string scene = contents(kSource / "sample_tools/laboratory/adhesive_bed.toml");
  const std::size_t from = scene.find("[powder]"), to = scene.find("[walls]");
  scene.replace(from, to - from, "[powder]\nfile = \"" + file.string() + "\"\n\n");
  const std::string tools = (kSource / "sample_tools/tradeoff/").string();
  // Of both tools.
  return support::exchanged(support::exchanged(scene, "../tradeoff/", tools), "../tradeoff/", tools);
}

TEST(SampleScenes, CanAllBeRead) {
  const SceneFolder folder;
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource / "sample_tools")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const std::string text = contents(entry.path());
    if (text.find("\n[[example]]\n") != std::string::npos) continue;  // what gallery.py reads
    if (text.find("\n[[tool]]\n") == std::string::npos && text.find("\n[powder]") != std::string::npos)
      EXPECT_NO_THROW(read_scene(folder.write(scene_with_powder_of(entry.path())))) << entry.path();
    else if (text.find("\n[[measurement]]\n") != std::string::npos)
      EXPECT_NO_THROW(calibration::read_calibration(entry.path())) << entry.path();
    else
      EXPECT_NO_THROW(read_scene(entry.path())) << entry.path();
  }
  EXPECT_GE(scenes, 1);
}

TEST(SampleScenes, StrategiesOfTheNarrowRingDifferInSpeedAndPassages) {
  std::vector<std::string> strategies;
  for (const Variant& variant : read_variants(kSource / "sample_tools/narrow_ring/strategies.toml"))
    strategies.push_back(strategy_text(variant.scene));
  const std::vector<std::string> expected = {"1 passage at 0.09 m/s",  "1 passage at 0.022 m/s",
                                             "1 passage at 0.044 m/s", "1 passage at 0.2 m/s",
                                             "2 passages at 0.09 m/s", "6 passages at 0.09 m/s"};
  EXPECT_EQ(strategies, expected);
}

TEST(SampleScenes, QuickStartIsOnePassageOverTheRing) {
  const Scene scene = read_scene(kSource / "sample_tools/narrow_ring/fill.toml");
  EXPECT_EQ(scene.powder.name, "Distaloy AE");
  EXPECT_NEAR(4 * scene.powder.sphere_radius, 3.136e-4, 1e-12);
  EXPECT_NEAR(coarse_graining_factor(scene.powder), 4, 1e-12);
  EXPECT_EQ(scene.tools.size(), 4U);
  EXPECT_EQ(strategy_text(scene), "1 passage at 0.2 m/s");
}

}  // namespace
}  // namespace diefill::process
