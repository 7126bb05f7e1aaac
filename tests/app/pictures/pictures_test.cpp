// One picture of every kind from a results file alone, with no display.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>

#include "process/results/storage/result_file.h"
#include "tests/app/program.h"
#include "tests/app/small_die.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

constexpr double kSize = 1e-3;  // m, grains of one sphere

void add_grain(results::FillResult& result, const Eigen::Vector3d& place) {
  auto& powder = result.powder;
  powder.id.push_back(powder.id.size());
  powder.position.push_back(place);
  powder.orientation.emplace_back(1, 0, 0, 0);
  powder.velocity.emplace_back(-place.y(), place.x(), -1e-3);
  powder.angular_velocity.push_back(Eigen::Vector3d::Zero());
  result.solid_fraction.solid_fraction.push_back(0.5 + 5 * place.z());
  result.solid_fraction.cell_volume.push_back(1e-9);
  result.solid_fraction.open.push_back(place.z() > -1e-3);
  result.solid_fraction.in_cavity.push_back(1);
  result.contact_stress.normal.emplace_back(1e-7 * place.z(), 1e-7 * place.z(), 3e-7 * place.z());
  result.contact_stress.shear.emplace_back(0, 0, 0);
}

/// A tetrahedron, so that there is a tool to cut and to move.
results::ToolState small_tool() {
  results::ToolState tool;
  tool.name = tool.role = "shoe";
  tool.vertices = {{-9e-3, -3e-3, 1e-3}, {9e-3, -3e-3, 1e-3}, {0, 6e-3, 1e-3}, {0, 0, 8e-3}};
  tool.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return tool;
}

results::FillResult small_ring() {
  results::FillResult result;
  result.strategy = "1 passage at 0.2 m/s";
  result.powder_name = "spheres";
  result.powder.time = 0.3;
  result.powder.grain_diameter = kSize;
  result.powder.sphere_radius = kSize / 2;
  result.powder.grain_solid_volume = std::numbers::pi / 6 * std::pow(kSize, 3);
  result.powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  for (double z = -4.5e-3; z < 0; z += kSize)
    for (double radius = 4.5e-3; radius < 8e-3; radius += kSize)
      for (int k = 0; k < 30; ++k) {
        const double angle = 2 * std::numbers::pi * k / 30;
        add_grain(result, {radius * std::cos(angle), radius * std::sin(angle), z});
      }
  result.tools = {small_tool()};
  result.cavity.is_ring = true;
  result.cavity.inner_radius = 4e-3;
  result.cavity.outer_radius = 8e-3;
  result.cavity.lower_corner = {-8e-3, -8e-3, -5e-3};
  result.cavity.upper_corner = {8e-3, 8e-3, 0};
  result.cavity.volume = std::numbers::pi * 48e-6 * 5e-3;
  results::SectionField section;
  section.plane.name = "middle";
  result.sections = {section};
  for (const double time : {0.1, 0.2}) {
    results::Instant instant{time,
                             result.powder.id,
                             result.powder.position,
                             result.powder.orientation,
                             result.powder.velocity,
                             {{1, 0, 0, 0}},
                             {{0.01 * time, 0, 0}}};
    for (auto& place : instant.position) place *= 1 - 0.02 * time;
    result.instants.push_back(instant);
  }
  result.probes = {{"filled mass", {"time", "filled mass"}, {"s", "kg"}, {0, 0, 0.1, 0.001, 0.3, 0.002}},
                   {"shoe", {"time", "force x", "shift x"}, {"s", "N", "m"}, {0, 0, 0, 0.3, 2, 0.06}}};
  return result;
}

class EveryPicture : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { unsetenv("DISPLAY"); }
  EveryPicture() {
    results::write_results(one(), small_ring());
    auto other = small_ring();
    for (double& value : other.solid_fraction.solid_fraction) value += 0.01;
    results::write_results(two(), other);
  }
  fs::path one() const { return folder_.path() / "one"; }
  fs::path two() const { return folder_.path() / "two"; }
  fs::path out() const { return folder_.path() / "out"; }
  Outcome map(std::vector<std::string> more, bool both = false) const {
    std::vector<std::string> arguments = {"map", one().string()};
    if (both) arguments.push_back(two().string());
    const std::vector<std::string> common = {"--out", out().string(), "--width", "400"};
    arguments.insert(arguments.end(), common.begin(), common.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

 private:
  support::TemporaryFolder folder_;
};

/// Kinds as the help lists them.
std::vector<std::string> kinds() {
  const std::string help = run_program({"map", "--help"}).out;
  std::vector<std::string> found;
  std::size_t at = help.find("Kinds of picture:\n");
  for (at = help.find('\n', at) + 1; help.compare(at, 2, "  ") == 0; at = help.find('\n', at) + 1)
    found.push_back(help.substr(at + 2, help.find(' ', at + 2) - at - 2));
  return found;
}

TEST_F(EveryPicture, IsMadeWithoutADisplay) {
  const auto all = kinds();
  ASSERT_GE(all.size(), 14U);
  for (const auto& kind : all) {
    SCOPED_TRACE(kind);
    const Outcome outcome = map({"--picture", kind, "--pdf"});
    if (kind.starts_with("size-")) {  // of powders of several sizes only: Sizes.RunMeasureAndDraw
      EXPECT_EQ(outcome.exit_code, 2);
      EXPECT_NE(outcome.err.find("all grains have one size"), std::string::npos) << outcome.err;
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string first = outcome.out.substr(0, outcome.out.find('\n'));
    EXPECT_TRUE(fs::exists(first)) << outcome.out;
    EXPECT_EQ(support::contents(first).substr(1, 3), "PNG");
  }
  EXPECT_EQ(support::contents(out() / "histogram.pdf").substr(0, 5), "%PDF-");
}

TEST_F(EveryPicture, OfTwoRunsSharesTheirScale) {
  const Outcome outcome =
      map({"--picture", "map", "--picture", "difference", "--picture", "histogram"}, true);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"map_one.png", "map_two.png", "difference_two.png", "histogram.png"})
    EXPECT_TRUE(fs::exists(out() / name)) << name;
}

TEST_F(EveryPicture, ThatDoesNotApplyIsNamedAndTheOthersAreDrawn) {
  const Outcome outcome = map({"--picture", "size-map", "--picture", "histogram"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("--picture size-map: "), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::exists(out() / "histogram.png"));
}

TEST_F(EveryPicture, OfProbesDrawsAnyColumnAgainstAnyOther) {
  const Outcome both = map({"--x", "shoe/shift x", "--y", "shoe/force x"}, true);
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_TRUE(fs::exists(out() / "probe.png"));
  const std::string against_time = [&] {
    EXPECT_EQ(map({"--y", "shoe"}).exit_code, 0);
    return support::contents(out() / "probe.png");
  }();
  EXPECT_EQ(map({"--y", "shoe", "--x", "shoe/shift x"}).exit_code, 0);
  EXPECT_NE(support::contents(out() / "probe.png"), against_time);
}

TEST_F(EveryPicture, OfProbesNamesTheColumnsThereAre) {
  const auto complaint = [&](const std::vector<std::string>& words) {
    const Outcome outcome = map(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(complaint({"--y", "shoe/force y"}).find("did you mean \"shoe/force x\"?"), std::string::npos);
  EXPECT_NE(complaint({"--y", "shoe/force x", "--y", "filled mass"}).find("columns of one unit"),
            std::string::npos);
  EXPECT_NE(complaint({"--y", "shoe", "--picture", "map"}).find("--picture probe"), std::string::npos);
}

TEST_F(EveryPicture, OfGrainsUnderPressureIsOfTheEndOnly) {
  EXPECT_EQ(map({"--picture", "view", "--colour-by", "pressure"}).exit_code, 0);
  const Outcome earlier = map({"--picture", "view", "--colour-by", "pressure", "--to", "0.1 s"});
  EXPECT_EQ(earlier.exit_code, 2);
  EXPECT_NE(earlier.err.find("of the end of a run only"), std::string::npos) << earlier.err;
}

TEST_F(EveryPicture, OfSeveralRunsIsCalledByWhatTellsThemApart) {
  const auto folder = out().parent_path();
  const auto make = [&](const std::string& place) {
    fs::create_directories(folder / place);
    results::write_results(folder / place, small_ring());
    return (folder / place).string();
  };
  const std::string fast = make("fast/seed-1"), slow = make("slow/seed-1"), again = make("slow/seed-2");
  const auto names = [&](const std::vector<std::string>& directories) {
    fs::remove_all(out());
    std::vector<std::string> arguments = {"map"};
    arguments.insert(arguments.end(), directories.begin(), directories.end());
    for (const char* more : {"--picture", "map", "--width", "400", "--out"}) arguments.push_back(more);
    arguments.push_back(out().string());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return SmallDie::files_in(out());
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({fast, slow}), (Names{"map_fast.png", "map_slow.png"}));
  EXPECT_EQ(names({slow, again}), (Names{"map_seed-1.png", "map_seed-2.png"}));
  EXPECT_EQ(names({fast, slow, again}),
            (Names{"map_fast_seed-1.png", "map_slow_seed-1.png", "map_slow_seed-2.png"}));
  EXPECT_EQ(names({fast, fast}), (Names{"map_seed-1.png", "map_seed-1_2.png"}));
}

TEST_F(EveryPicture, IsOfTheCavityAskedFor) {
  auto twin = small_ring();
  twin.other_cavities = {twin.cavity};
  twin.other_cavities[0].outer_radius = 6e-3;
  results::write_results(one(), twin);
  const auto drawn = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--picture", "map"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = map(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return support::contents(out() / "map.png");
  };
  const std::string largest = drawn({});
  EXPECT_EQ(drawn({"--cavity", "1"}), largest);
  EXPECT_NE(drawn({"--cavity", "2"}), largest);
  const Outcome outcome = map({"--picture", "map", "--cavity", "3"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U);
  EXPECT_NE(outcome.err.find("--cavity: found 3; the tools have cavities 1 to 2"), std::string::npos)
      << outcome.err;
}

TEST_F(EveryPicture, OfThePressureSaysWhatOlderResultsLack) {
  auto older = small_ring();
  older.contact_stress = {};
  results::write_results(one(), older);
  const Outcome outcome = map({"--picture", "pressure"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("contain no contact stress"), std::string::npos) << outcome.err;
}

TEST_F(EveryPicture, OverTimeTakesAllInstantsBetween) {
  for (const auto& kind : {"map", "section", "velocity", "velocity-section", "height-profile", "histogram"}) {
    SCOPED_TRACE(kind);
    const Outcome outcome = map({"--picture", kind, "--time-average", "--from", "0.05 s"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

TEST_F(EveryPicture, AndItsNumbersCanBeHadForParaView) {
  const Outcome outcome = run_program({"export", one().string(), "--out", out().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"powder_0000.vtp", "powder_0001.vtp", "powder.vtp", "tools.vtp", "fields.vti"}) {
    const std::string text = support::contents(out() / name);
    EXPECT_NE(text.find("<VTKFile type="), std::string::npos) << name;
    EXPECT_NE(text.find("</VTKFile>"), std::string::npos) << name;
  }
  const std::string powder = support::contents(out() / "powder.vtp");
  EXPECT_NE(powder.find("NumberOfPoints=\"600\""), std::string::npos);
  for (const char* array : {"\"solid fraction\"", "\"velocity [m/s]\"", "\"pressure [Pa]\""})
    EXPECT_NE(powder.find(std::string("Name=") + array), std::string::npos) << array;
  const std::string series = support::contents(out() / "filling.pvd");
  EXPECT_LT(series.find("powder_0000.vtp"), series.find("powder.vtp"));
  const Outcome wrong = run_program({"export", one().string(), "--averaging-width", "1"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("--averaging-width"), std::string::npos) << wrong.err;
}

TEST_F(EveryPicture, ExportRefusesFilesAsDirectoriesAndOptionsThatSayNothing) {
  const fs::path file = one() / "file", grown = one() / "new";
  std::ofstream(file) << "mine";
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--out", file.string()}, "is a file, not a directory"},
      {{"--out", (file / "below").string()}, "is a file, not a directory"},
      {{"--averaging-width", "1 nm"}, "from a tenth of a grain"},
      {{"--averaging-width", "1 km"}, "to the largest edge of the cavity"},
      {{"--mesh-share", "0.5"}, "--mesh-share: says nothing without --density-for"},
      {{"--mesh-unit", "m"}, "--mesh-unit: says nothing without --density-for"},
      {{"--mass", "1 g"}, "--mass: says nothing without --density-for or --density-grid"},
      {{"--cavity", "1"}, "--cavity: says nothing without --density-for or --density-grid"},
      {{"--mesh-position", "0 mm", "0 mm", "0 mm", "--density-grid", "1 mm"},
       "--mesh-position: says nothing"},
      {{"--mesh-share", "nan", "--density-for", "a.inp"}, "--mesh-share: found \"nan\""},
      {{"--mesh-share", "inf", "--density-for", "a.inp"}, "--mesh-share: found \"inf\""},
      {{"--density-grid", "10 m"}, "--density-grid: found \"10 m\", allowed: more than 0, at most 16 mm"},
      {{"--density-grid", "1 nm", "--mass", "1 g"}, "20 million cells"},
  };
  for (const auto& [more, expected] : wrong) {
    SCOPED_TRACE(expected);
    std::vector<std::string> arguments = {"export", one().string()};
    if (more.front() != "--out") arguments.insert(arguments.end(), {"--out", grown.string()});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_FALSE(fs::exists(grown));
  }
  EXPECT_EQ(support::contents(file), "mine");
}

TEST_F(EveryPicture, ReportOverwritesNothingThatItReads) {
  const std::string before = support::contents(one() / "results.h5");
  fs::create_hard_link(one() / "results.h5", one() / "link.html");
  fs::create_directory(one() / "folder.html");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& expected) {
    std::vector<std::string> arguments = {"report", one().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << expected;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
  };
  refused({"--out", (one() / "results.h5").string()}, "a file that ends in .html or .htm");
  refused({"--out", (one() / "link.html").string()}, "which the command reads");
  refused({"--out", (one() / "folder.html").string()}, "which is a directory");
  refused({"--out", (one() / "results.h5" / "page.html").string()}, "is a file, not a directory");
  refused({one().string()}, "which are the same results");
  refused({two().string(), (two() / ".." / "one").string()}, "which are the same results");
  EXPECT_EQ(support::contents(one() / "results.h5"), before);
}

TEST_F(EveryPicture, WrongWordsAreExplainedInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--picture", "hystogram"}, "did you mean \"histogram\"?"},
      {{"--picture", "section", "--normal", "0,0,0"}, "three numbers not all 0"},
      {{"--picture", "view", "--camera", "behind"}, "azimuth and elevation"},
      {{"--picture", "difference", "--from", "9 s"}, "the results contain 2 from 0.1 s to 0.2 s"},
      {{"--picture", "displacement", "--from", "0.2 s", "--to", "0.1 s"}, "must come before"},
      {{"--picture", "map", "--range", "0.4", "0.3"}, "must be less than"},
      {{"--picture", "map", "--range", "nan", "nan"}, "--range: found \"nan\", allowed: a finite number"},
      {{"--picture", "map", "--range", "0.3", "inf"}, "--range: found \"inf\""},
      {{"--picture", "map", "--range", "0.3", "1e999"}, "--range: found \"1e999\""},
      {{"--picture", "map", "--averaging-width", "1 nm"}, "from a tenth of a grain"},
      {{"--picture", "map", "--averaging-width", "1 km"}, "to 16 mm"},
      {{"--picture", "section", "--origin", "1e9 m", "0 m", "0 m"}, "--origin: found \"1e9 m\""},
      {{"--picture", "section", "--origin", "0 mm", "0 mm", "40 mm"}, "outside die and powder"},
      {{"--picture", "map", "--from", "-1 s"}, "--from: found \"-1 s\", allowed: 0 s to"},
      {{"--picture", "map", "--cavity", "0"}, "--cavity: found \"0\""},
      {{"--picture", "view", "--colour-by", "sped"}, "did you mean \"speed\"?"},
      {{"--picture", "view", "--camera", "frnt"}, "did you mean \"front\""},
      {{"--picture", "view", "--time-average"}, "shows one instant; allowed: map plan-map section"},
      {{"--picture", "map", "--time-average", "--from", "0.25 s"}, "at least two instants"},
  };
  for (const auto& [arguments, expected] : wrong) {
    SCOPED_TRACE(expected);
    const Outcome outcome = map(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace diefill::app
