// Figures as tables of a report show them: units, and differences that are none.
#include <gtest/gtest.h>

#include "render/report/comparison.h"
#include "render/report/sections/filling_section.h"
#include "render/report/sections/strategies.h"

namespace diefill::render::report {
namespace {

/// The row of this title in any table of the sections; empty where there is none.
std::vector<std::string> row_of(const std::vector<Section>& sections, const std::string& caption,
                                const std::string& title) {
  for (const Section& section : sections)
    for (const auto& block : section.blocks)
      if (const Table* table = std::get_if<Table>(&block); table != nullptr && table->caption == caption)
        for (const auto& row : table->rows)
          if (row.front() == title) return row;
  return {};
}

TEST(ShownFigures, PlainNumbersOfZonesHaveNoUnit) {
  results::FillResult result;
  result.figures = {{"solid_fraction_in_upper_half", 0.3071}, {"filled_mass_in_upper_half_kg", 1.25e-3}};
  const std::vector<Section> sections = {filling_section(result)};
  const std::string caption = "Zones and heaps of the scene";
  EXPECT_EQ(row_of(sections, caption, "Solid fraction in upper half"),
            (std::vector<std::string>{"Solid fraction in upper half", "0.307"}));
  EXPECT_EQ(row_of(sections, caption, "Filled mass of model powder in upper half"),
            (std::vector<std::string>{"Filled mass of model powder in upper half", "1.25 g"}));
}

Run run_with(const std::string& name, double cycle_time) {
  Run run;
  run.name = run.result.strategy = name;
  run.result.scene_text = "title = \"" + name + "\"\nfriction = " + std::to_string(name.size()) + "\n";
  run.result.figures = {{"cycle_time_s", cycle_time}, {"fill_ratio", 0.7}};
  return run;
}

TEST(ShownFigures, DifferencesByRoundingAloneAreZero) {
  const std::vector<report::Run> runs = {run_with("first", 0.31), run_with("second", 0.31 + 1.1e-16),
                                         run_with("the third", 0.62)};
  const auto sections = comparison_sections(strategies_of(runs));
  const auto same = row_of(sections, "Change of the mean", "second"),
             other = row_of(sections, "Change of the mean", "the third");
  ASSERT_FALSE(same.empty());
  EXPECT_EQ(same.back(), "0");
  EXPECT_EQ(other.back(), "+0.31 (+100 %)");
}

}  // namespace
}  // namespace diefill::render::report
