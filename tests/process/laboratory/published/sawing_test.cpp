// Runs of wire sawing: a stopped one ends as one that was not, figures survive their file, grains are kept
// for a film.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/custom_runs.h"
#include "process/laboratory/published/sawing/groove_charts.h"
#include "process/laboratory/published/sawing/sawing_json.h"
#include "process/results/storage/result_file.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory::sawing {
namespace {

/// Keeps the state of a run at a share of its work, and stops it there.
class Stopping final : public CustomRunWatch {
 public:
  Stopping(const std::filesystem::path& folder, double stop_at) : folder_(folder), stop_at_(stop_at) {}
  const std::filesystem::path& folder() const override { return folder_; }
  const std::string& begun() const override { return state_; }
  void report(double share, const std::function<std::string()>& state) override {
    if (stopped_ || share < stop_at_) return;
    stopped_ = true;
    state_ = state();
    throw CustomRunStopped("stopped");
  }

 private:
  std::filesystem::path folder_;
  double stop_at_;
  bool stopped_ = false;
  std::string state_;
};

/// A thin wire in a short groove.
GrooveCase small_groove() {
  return {.wire_radius = 3,
          .groove_radius = 6,
          .top = 5,
          .length = 4,
          .speed = 0.5,
          .pressure = 5,
          .solids = 0.15,
          .settling = 100,
          .sampled = 200,
          .instants = 6};
}

TEST(WireSawing, AGrooveThatWasStoppedEndsAsOneThatWasNot) {
  const support::TemporaryFolder folder;
  Stopping never(folder.path(), 2), once(folder.path(), 0.6);
  const std::string straight = text_of(saw(small_groove(), 3, never));
  EXPECT_THROW(saw(small_groove(), 3, once), CustomRunStopped);
  EXPECT_EQ(text_of(saw(small_groove(), 3, once)), straight);
}

TEST(WireSawing, AShearedBoxThatWasStoppedEndsAsOneThatWasNot) {
  const ShearedSlurry slurry{.edge = 5, .rate = 0.2, .solids = 0.1, .settling = 40, .sampled = 100};
  Stopping once("", 0.5);
  EXPECT_THROW(measure(slurry, 1, once), CustomRunStopped);
  EXPECT_EQ(text_of(measure(slurry, 1, once)), text_of(measure(slurry, 1)));
}

TEST(WireSawing, FiguresSurviveTheirFile) {
  const support::TemporaryFolder folder;
  Stopping never(folder.path(), 2);
  const GrooveFigures figures = saw(small_groove(), 1, never);
  EXPECT_FALSE(figures.gap.empty() || figures.stress.empty() || figures.grains.empty());
  EXPECT_FALSE(figures.section.empty() || figures.distance.empty());
  const GrooveFigures read = groove_figures(text_of(figures));
  EXPECT_EQ(text_of(read), text_of(figures));
  EXPECT_DOUBLE_EQ(share_at_centre(read), share_at_centre(figures));
  const ShearedFigures sheared{1.25, std::nan(""), 2.4, 0.1, 0.2, 100};
  EXPECT_EQ(text_of(sheared_figures(text_of(sheared))), text_of(sheared));
}

TEST(WireSawing, KeepsItsGrainsForAFilm) {
  const support::TemporaryFolder folder;
  Stopping never(folder.path(), 2);
  const GrooveCase one = small_groove();
  saw(one, 1, never);
  const results::FillResult film = results::read_results(folder.path());
  EXPECT_EQ(film.instants.size(), 5U);  // and the end
  ASSERT_FALSE(film.powder.position.empty());
  EXPECT_EQ(film.instants.front().id, film.powder.id);
  EXPECT_LT(film.instants.front().time, film.powder.time);
  ASSERT_EQ(film.tools.size(), 2U);
  constexpr double kMetre = 1e-6 * ReducedUnits::micrometres;
  for (const auto& place : film.powder.position) {
    EXPECT_LT(std::abs(place.x()), one.groove_radius * kMetre);
    EXPECT_LE(std::abs(place.y()), 0.5001 * one.length * kMetre);
  }
  // The wire sinks: earlier it stands higher than at the end.
  EXPECT_GT(film.instants.front().tool_displacement[0].z(), 0);
  EXPECT_NEAR(film.powder.largest_diameter(), 4 * kMetre, 1e-12);
}

TEST(WireSawing, FluidStaysInTheGroove) {
  const support::TemporaryFolder folder;
  Stopping never(folder.path(), 2);
  GrooveCase one = small_groove();
  one.pressure = 0, one.solids = 0, one.instants = 0;
  const GrooveFigures figures = saw(one, 1, never);
  constexpr double kIntoWalls = 0.3;
  for (const SectionPoint& point : figures.section) {
    if (point.part != SectionPoint::Part::fluid) continue;
    const double from_axis = std::hypot(point.x, point.z);
    EXPECT_LT(point.z < 0 ? from_axis : std::abs(point.x), one.groove_radius + kIntoWalls);
    EXPECT_LT(point.z, one.top + kIntoWalls);
    EXPECT_GT(from_axis, one.wire_radius - kIntoWalls);
  }
  EXPECT_NEAR(figures.temperature, 1, 0.05);
}

TEST(WireSawing, RunsOfOtherSettingsHaveOtherKeys) {
  GrooveCase longer = small_groove();
  longer.length *= 2;
  EXPECT_NE(settings_text(longer), settings_text(small_groove()));
  EXPECT_GT(work_of(longer), 1.5 * work_of(small_groove()));
  ShearedSlurry slurry, thinner;
  thinner.solids = 0.2;
  EXPECT_NE(settings_text(slurry), settings_text(thinner));
}

TEST(WireSawing, ChangeOfTheDistanceIsZeroOnceTheWireKeepsItsHeight) {
  GrooveFigures figures;
  for (int k = 0; k < 300; ++k) figures.distance.push_back(k < 100 ? 4 - 0.01 * k : 3);
  EXPECT_DOUBLE_EQ(late_change(figures), 0);
  for (int k = 0; k < 300; ++k) figures.distance[static_cast<std::size_t>(k)] = 4 - 0.01 * k;
  EXPECT_NEAR(late_change(figures), -1, 0.01);
}

}  // namespace
}  // namespace diefill::process::laboratory::sawing
