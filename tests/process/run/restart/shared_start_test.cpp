// Which runs begin alike, and what they leave for each other.
#include "process/run/restart/shared_start.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"

namespace diefill::process {
namespace {

constexpr double kNow = 0.5;  // s

std::string two_steps() {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "passage"
tool = "shoe"
velocity = "0.2 m/s"
direction = "-x"

[[step]]
kind = "vibration"
tool = "die"
axis = "y"
amplitude = "1 mm"
frequency = "32 Hz"
duration = "1 s"
)";
  return support::scene_text(tables);
}

/// A run of a scene with two steps, the first of them over; the second begins now unless a test says
/// otherwise.
class SharedStart : public testing::Test {
 protected:
  SharedStart() {
    tooling_.tools.emplace_back().spheres.centres = {{0, 0, 0}, {1e-3, 0, 0}};
    schedule_.steps.resize(4);
    schedule_.steps[0].started = 0;
    schedule_.steps[0].ended = schedule_.steps[1].started = 0.1;
    schedule_.steps[1].ended = schedule_.steps[2].started = kNow;
    frame_.domain.include(Eigen::Vector3d::Zero());
  }

  std::uint64_t hash_of(const std::string& text) const {
    RunFrame frame = frame_;
    frame.inputs = input_files(text, folder_.path() / "scene.toml");
    return hash_of(text, frame);
  }
  std::uint64_t hash_of(const std::string& text, const RunFrame& frame) const {
    return start_hash(parse_scene(text, folder_.path() / "scene.toml"), tooling_, frame, schedule_, kNow);
  }
  std::uint64_t hash() const { return hash_of(two_steps()); }
  std::uint64_t hash_with(const std::string& old, const std::string& replacement) const {
    return hash_of(support::exchanged(two_steps(), old, replacement));
  }

  SceneFolder folder_;
  Tooling tooling_;
  RunFrame frame_{.time_step = 1e-6, .domain = {}};  ///< without inputs
  ScheduleState schedule_;
};

TEST_F(SharedStart, IsCommonToScenesThatDifferInWhatIsYetToCome) {
  for (const auto& [old, other] :
       {std::pair{"32 Hz", "20 Hz"}, {"\"y\"", "\"x\""}, {"one passage", "another"}})
    EXPECT_EQ(hash_with(old, other), hash()) << other;
  schedule_.steps[2].started = -1;
  EXPECT_EQ(hash_with("32 Hz", "20 Hz"), hash());
}

TEST_F(SharedStart, IsCommonToScenesOfOtherSnapshots) {
  EXPECT_EQ(hash_of(two_steps() + "\n[[snapshot]]\nname = \"half\"\nwhen = { at = \"0.2 s\" }\n"), hash());
}

TEST_F(SharedStart, IsCommonToScenesOfMoreAndFewerStepsToCome) {
  const std::uint64_t of_two = hash();
  const std::string text = two_steps();
  const std::size_t second = text.find("[[step]]\nkind = \"vibration\""),
                    end = text.find("duration = \"1 s\"\n", second);
  ASSERT_NE(end, std::string::npos);
  const std::string one_step = std::string(text).erase(second, end + 17 - second);
  const auto fewer = with_steps(schedule_, 3);
  ASSERT_TRUE(fewer.has_value());
  schedule_ = *fewer;
  EXPECT_EQ(hash_of(one_step), of_two);
  // Back again: what is to come waits.
  const auto more = with_steps(schedule_, 4);
  ASSERT_TRUE(more.has_value());
  EXPECT_TRUE(more->steps[3].is_pending());
  EXPECT_FALSE(with_steps(schedule_, 2).has_value());
}

TEST_F(SharedStart, IsAnotherWhereScenesDifferInWhatHasActed) {
  for (const auto& [old, other] : {std::pair{"0.2 m/s", "0.1 m/s"},
                                   {"seed = 1", "seed = 2"},
                                   {"1.88 mm", "0.94 mm"},
                                   {"spacing = 1.6", "spacing = 1.7"}})
    EXPECT_NE(hash_with(old, other), hash()) << other;
  schedule_.steps[2].started = 0.9 * kNow;
  EXPECT_NE(hash_with("32 Hz", "20 Hz"), hash());
}

TEST_F(SharedStart, IsAnotherWhereTheTableThatAStepHasFollowedHoldsOtherPoints) {
  const auto of_table = [&](const std::string& name, const std::string& point) {
    std::ofstream(folder_.path() / name) << "time s,x mm\n0,0\n" << point << '\n';
    return hash_with("kind = \"passage\"\ntool = \"shoe\"\nvelocity = \"0.2 m/s\"\ndirection = \"-x\"",
                     "kind = \"table\"\ntool = \"shoe\"\nfile = \"" + name + '"');
  };
  const std::uint64_t before = of_table("motion.csv", "0.1,1");
  EXPECT_EQ(of_table("renamed.csv", "0.1,1"), before);
  EXPECT_NE(of_table("motion.csv", "0.1,2"), before);
}

TEST_F(SharedStart, IsAnotherWhereTheFileOfPlacedGrainsHoldsOthers) {
  const auto of_grains = [&](const std::string& second) {
    std::ofstream(folder_.path() / "grains.csv") << "x [mm], y [mm], z [mm], radius [mm]\n20, 0, 1, 1\n"
                                                 << second << '\n';
    return hash_with(support::SceneTables().pour, "grains_file = \"grains.csv\"\n");
  };
  const std::uint64_t before = of_grains("24.5, 2, 3, 1");
  EXPECT_EQ(of_grains("24.5, 2, 3, 1"), before);
  EXPECT_NE(of_grains("24.5, 2, 4, 1"), before);
}

TEST_F(SharedStart, IsOfTheFilesAsTheyWereReadThoughTheyAreEditedSince) {
  const auto write = [&](const std::string& grain, const std::string& point) {
    std::ofstream(folder_.path() / "grains.csv") << "x [mm], y [mm], z [mm], radius [mm]\n" << grain << '\n';
    std::ofstream(folder_.path() / "motion.csv") << "time s,x mm\n0,0\n" << point << '\n';
  };
  const std::string table = support::exchanged(
      two_steps(), "kind = \"passage\"\ntool = \"shoe\"\nvelocity = \"0.2 m/s\"\ndirection = \"-x\"",
      "kind = \"table\"\ntool = \"shoe\"\nfile = \"motion.csv\"");
  const std::string text =
      support::exchanged(table, support::SceneTables().pour, "grains_file = \"grains.csv\"\n");
  write("24.5, 2, 3, 1", "0.1,1");
  RunFrame frame = frame_;
  frame.inputs = input_files(text, folder_.path() / "scene.toml");
  const std::uint64_t before = hash_of(text, frame);
  write("24.5, 2, 4, 1", "0.1,2");
  EXPECT_EQ(hash_of(text, frame), before);
  EXPECT_NE(hash_of(text), before);
}

TEST_F(SharedStart, IsAnotherWhereTheNextStepMayHaveBegunEarlier) {
  schedule_.steps[2].started = -1;
  EXPECT_NE(hash_with("duration = \"1 s\"", "duration = \"1 s\"\nstart = { at = \"0.2 s\" }"), hash());
}

TEST_F(SharedStart, IsAnotherWhereTheNextStepTakesPowderAwayAtOnce) {
  const std::string cleared =
      support::exchanged(two_steps(),
                         "kind = \"vibration\"\ntool = \"die\"\naxis = \"y\"\namplitude = \"1 "
                         "mm\"\nfrequency = \"32 Hz\"\nduration = \"1 s\"",
                         "kind = \"clear\"\nheap = \"2 mm\"");
  EXPECT_NE(hash_of(cleared), hash());
  EXPECT_NE(hash_of(support::exchanged(cleared, "2 mm", "3 mm")), hash_of(cleared));
}

TEST_F(SharedStart, IsAnotherForOtherWallsStepsAndBounds) {
  const std::uint64_t before = hash();
  tooling_.tools[0].spheres.centres[1][2] = 1e-9;
  const std::uint64_t moved = hash();
  EXPECT_NE(moved, before);
  frame_.time_step = 2e-6;
  const std::uint64_t longer = hash();
  EXPECT_NE(longer, moved);
  frame_.domain.include(Eigen::Vector3d::Ones());
  EXPECT_NE(hash(), longer);
}

TEST(LatestBeginning, IsTheLastOfItsOwnAndPassesOverDamagedFiles) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(
      latest_shared_start(folder.path() / "none", [](const Checkpoint&) { return true; }).has_value());
  for (int n = 1; n <= 3; ++n) {
    Checkpoint checkpoint;
    checkpoint.start_hash = static_cast<std::uint64_t>(n);
    checkpoint.simulation.time = 0.1 * n;
    save_shared_start(folder.path(), checkpoint);
  }
  std::ofstream(folder.path() / "9.bin") << "not a checkpoint";
  const auto own = latest_shared_start(folder.path(), [](const Checkpoint& c) { return c.start_hash != 3; });
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->simulation.time, 0.2);
}

}  // namespace
}  // namespace diefill::process
