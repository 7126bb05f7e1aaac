// One picture of every kind from a results file alone, with no display.
#include <algorithm>
#include <sstream>

#include "process/results/storage/earlier_results.h"
#include "process/results/storage/result_file.h"
#include "tests/app/pictures/every_picture.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// Kinds as the help lists them.
std::vector<std::string> kinds() {
  const std::string help = run_program({"map", "--help"}).out;
  std::vector<std::string> found;
  std::size_t at = help.find("Kinds of picture:\n");
  for (at = help.find('\n', at) + 1; help.compare(at, 2, "  ") == 0; at = help.find('\n', at) + 1)
    found.push_back(help.substr(at + 2, help.find(' ', at + 2) - at - 2));
  return found;
}

/// A later run into the directory would move all files that the lines name.
void expect_known_names(const fs::path& directory, const std::string& lines) {
  EXPECT_NE(lines, "");
  std::istringstream stream(lines);
  for (std::string file; std::getline(stream, file);)
    EXPECT_TRUE(results::would_be_moved(directory, file)) << file;
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
    expect_known_names(out(), outcome.out);
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

// The names in the help are those that load probes give to their columns.
TEST_F(EveryPicture, OfProbesIsExplainedByColumnsThatThereAre) {
  const std::string help = run_program({"map", "--help"}).out;
  EXPECT_NE(help.find("--x 'press/shift z' --y 'press/force z'"), std::string::npos) << help;
  const Outcome wrong = map({"--y", "nothing"});
  EXPECT_NE(wrong.err.find("found \"nothing\"; allowed: \"filled mass/filled mass\", \"shoe/force x\""),
            std::string::npos)
      << wrong.err;
}

// A second run ten times as fast changes what the first one's picture looks like: the scale is that of both.
TEST_F(EveryPicture, OfSpeedsOfSeveralRunsIsOnOneScale) {
  const std::vector<std::vector<std::string>> kinds = {{"--picture", "velocity"},
                                                       {"--picture", "view", "--colour-by", "speed"}};
  const auto first_of_both = [&](const std::vector<std::string>& words) {
    EXPECT_EQ(map(words, true).exit_code, 0);
    return support::contents(out() / (words[1] + "_one.png"));
  };
  const std::string alike = first_of_both(kinds[0]), alike_view = first_of_both(kinds[1]);
  auto fast = small_ring();
  for (auto& velocity : fast.powder.velocity) velocity *= 10;
  for (auto& instant : fast.instants)
    for (auto& velocity : instant.velocity) velocity *= 10;
  results::write_results(two(), fast);
  EXPECT_NE(first_of_both(kinds[0]), alike);
  EXPECT_NE(first_of_both(kinds[1]), alike_view);
}

TEST_F(EveryPicture, OfSeveralRunsIsInThePlaneOfTheFirst) {
  for (const std::string kind : {"section", "velocity-section", "pressure-section"}) {
    SCOPED_TRACE(kind);
    results::write_results(two(), small_ring());
    const auto of_second = [&] {
      const Outcome outcome = map({"--picture", kind}, true);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      const std::string lines = outcome.out;
      const std::size_t at = lines.find('\n') + 1;
      return support::contents(lines.substr(at, lines.find('\n', at) - at));
    };
    const std::string alike = of_second();
    auto turned = small_ring();
    turned.sections[0].plane.normal = {1, 0, 0};
    turned.sections[0].plane.first_axis = {0, 1, 0};
    results::write_results(two(), turned);
    EXPECT_EQ(of_second(), alike);
  }
}

TEST_F(EveryPicture, InAPlaneWithoutPowderOfOneRunIsRefusedInOneLine) {
  auto away = small_ring();
  for (auto& place : away.powder.position) place.y() += 1;
  results::write_results(two(), away);
  const Outcome outcome = map({"--picture", "section"}, true);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("found no powder of two near the plane, which is the same for all results"),
            std::string::npos)
      << outcome.err;
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

}  // namespace
}  // namespace diefill::app
