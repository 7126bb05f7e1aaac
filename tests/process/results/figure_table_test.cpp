// The table of figures: complete, known to all that write figures, and the one place with labels and units.
#include "process/results/figure_table.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "process/compare/compared_measures.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/heap_slope.h"
#include "process/measure/figures/zone.h"
#include "process/tradeoff/quantities.h"
#include "project_paths.h"
#include "tests/process/measure_sample.h"
#include "tests/process/results_sample.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Sources below `folder` of the project.
std::vector<fs::path> sources_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(DIEFILL_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") files.push_back(entry.path());
  return files;
}

/// Names of the figures that code of `process` sets by a name that stands in it.
std::set<std::string> names_in_code() {
  const std::regex written(R"re((?:figures\[(?:prefix \+ )?|set_no_value\(\w+, )"([^"]*[^"_])"[\],])re");
  std::set<std::string> names;
  for (const auto& file : sources_in("process")) {
    if (file.string().find("/laboratory/") != std::string::npos) continue;  // figures of beds are variables
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), written), end; match != end; ++match)
      names.insert((*match)[1].str());
  }
  return names;
}

/// A full ring, or a box along x, of grains of two sizes that stand on a lattice.
FillResult two_sizes_in(bool ring) {
  FillResult result;
  std::vector<Eigen::Vector3d> places;
  if (ring) {
    result.cavity = process::sample_ring();
    places = process::lattice_in_ring(result.cavity, 4e-4, [](double) { return 6e-3; });
  } else {
    result.cavity.lower_corner = {-4e-3, -4e-3, -8e-3};
    result.cavity.upper_corner = {4e-3, 4e-3, 0};
    for (const auto& place : process::block(16, 5e-4)) places.push_back(place - Eigen::Vector3d(0, 0, 4e-3));
  }
  result.cavity.volume = 1e-6;
  result.powder = process::powder_of(places, 4e-4);
  result.powder.kinds = {
      {4e-4, 3e-4}, {2e-4, 1.5e-4}, {7.6e-8, 3.2e-8}, {3.3e-11, 1.4e-11}, {"a", "b"}, {}, {}, {}};
  for (std::size_t k = 0; k < places.size(); ++k) result.powder.kind.push_back(k % 3 == 0 ? 1 : 0);
  result.solid_fraction = process::fraction_of(result.powder, [](const auto&) { return 0.4; });
  return result;
}

/// Names of all figures that runs write.
std::set<std::string> written_names() {
  std::set<std::string> names = names_in_code();
  for (const bool ring : {true, false}) {
    FillResult result = two_sizes_in(ring);
    process::measure_figures(result);
    for (const auto& [name, value] : result.figures) names.insert(name);
  }
  names.insert(process::heap_figure("the heap"));
  names.insert({process::zone_mass_figure("flange"), process::zone_share_figure("flange"),
                process::zone_solid_fraction_figure("flange")});
  names.insert({"solid_fraction_mean", "solid_fraction_std"});  // of the summary
  return names;
}

TEST(FigureTable, SaysUnitMeaningAndLabelOfEveryFigure) {
  std::set<std::string> names, labels;
  for (const Figure& figure : figure_table()) {
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
    EXPECT_TRUE(labels.insert(figure.label).second) << figure.name;
    EXPECT_NE(*figure.unit, '\0') << figure.name;
    EXPECT_NE(*figure.meaning, '\0') << figure.name;
    EXPECT_NE(*figure.label, '\0') << figure.name;
    EXPECT_NE(*figure.shown.unit, '\0') << figure.name;
    EXPECT_GT(figure.shown.factor, 0) << figure.name;
    EXPECT_GT(figure.shown.digits, 0) << figure.name;
    if (std::string(figure.name).starts_with("energy_")) {  // one name for one thing
      EXPECT_EQ(std::string(figure.label).find("turned over"), std::string::npos) << figure.name;
    }
  }
}

TEST(FigureTable, UnitsAreThoseThatNamesEndIn) {
  for (const Figure& figure : figure_table())
    EXPECT_STREQ(figure.unit, figure_meaning(std::string("unknown_") + figure.name).first) << figure.name;
}

TEST(FigureTable, UnitsThatUsersSeeAreStoredOnesTimesTheFactor) {
  const std::map<std::pair<std::string, std::string>, double> factors = {
      {{"kg", "g"}, 1e3},       {{"m", "mm"}, 1e3},
      {{"s", "µs"}, 1e6},       {{"m^3", "cm^3"}, 1e6},
      {{"1", "%"}, 100},        {{"kg/m^3", "g/cm^3"}, 1e-3},
      {{"1", "million"}, 1e-6}, {{"1/s", "million sphere-steps/s"}, 1e-6}};
  for (const Figure& figure : figure_table()) {
    const auto known = factors.find({figure.unit, figure.shown.unit});
    const bool same = std::string(figure.unit) == figure.shown.unit;
    EXPECT_TRUE(same || known != factors.end()) << figure.name;
    EXPECT_EQ(figure.shown.factor, known == factors.end() ? 1 : known->second) << figure.name;
  }
}

TEST(FigureTable, KnowsEveryFigureThatIsWritten) {
  const auto names = written_names();
  EXPECT_GT(names.size(), 60U);
  for (const auto& name : names) EXPECT_NE(find_figure(name), nullptr) << name;
}

TEST(FigureTable, HoldsNoFigureThatNothingWrites) {
  std::set<std::string> known;
  for (const auto& name : written_names())
    if (const Figure* figure = find_figure(name)) known.insert(figure->name);
  for (const Figure& figure : figure_table()) EXPECT_TRUE(known.contains(figure.name)) << figure.name;
}

TEST(FigureTable, SmallerCavitiesAndHeapsHaveTheEntryOfTheirKind) {
  EXPECT_STREQ(find_figure("cavity_2_fill_ratio")->name, "fill_ratio");
  EXPECT_STREQ(find_figure("cavity_12_volume_m3")->name, "cavity_volume_m3");
  EXPECT_STREQ(find_figure("cavity_2_solid_fraction")->name, "solid_fraction_mean");
  EXPECT_STREQ(find_figure("cavity_2_cavity_solid_fraction")->name, "cavity_solid_fraction");
  EXPECT_EQ(label_of(figure_called(process::heap_figure("left one")), "left one"), "slope of left one");
  EXPECT_NE(find_figure(process::heap_figure("")), nullptr);
  EXPECT_EQ(find_figure("cavity_fill_ratio"), nullptr);
  EXPECT_EQ(find_figure("narrowest_mm"), nullptr);
  EXPECT_THROW(figure_called("narrowest_mm"), std::out_of_range);
}

TEST(FigureTable, ValuesAreThoseOfTheResult) {
  const FillResult result = sample_result();
  EXPECT_EQ(figure_of(result, "steps"), 123456789);
  EXPECT_EQ(figure_of(result, "solid_fraction_mean"), 0.341);
  EXPECT_EQ(figure_of(result, "solid_fraction_std"), 0.02);
  EXPECT_TRUE(std::isnan(figure_of(result, "fill_ratio")));
}

TEST(FigureTable, SaysByWhatVariantsAreCompared) {
  std::vector<std::string> marked;
  for (const Figure& figure : figure_table())
    if (figure.compared) marked.emplace_back(figure.name);
  const auto& measures = process::compared_measures();
  ASSERT_EQ(measures.size(), marked.size());
  EXPECT_EQ(measures.size(), 25U);
  for (std::size_t k = 0; k < marked.size(); ++k) {
    EXPECT_EQ(measures[k].key, marked[k]);
    EXPECT_EQ(measures[k].name, figure_called(marked[k]).label);
  }
  // Scripts find these rows of comparison.csv by name.
  EXPECT_EQ(measures[2].name, "fill ratio of a die full at apparent density");
  EXPECT_EQ(measures[3].name, "filled mass of model powder");
  EXPECT_EQ(measures[3].unit, "g");
  EXPECT_NEAR(process::value_of(measures[3], sample_result()), 1 / 3.0, 1e-15);
  EXPECT_EQ(measures[9].period, 360);
}

TEST(FigureTable, TradeOffQuantitiesHaveItsLabelsAndKeepTheirNamesInFiles) {
  process::Scene scene;
  scene.measure.heaps.push_back({.name = "left one"});
  const auto all = process::measured_quantities(scene);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[0].about.key, "filled_mass");
  EXPECT_EQ(all[0].about.name, figure_called("filled_mass_kg").label);
  EXPECT_EQ(all[0].about.name_in_files(), "filled mass");
  EXPECT_EQ(all[0].about.unit, "g");
  EXPECT_EQ(all[1].about.name_in_files(), "mean solid fraction");
  EXPECT_EQ(all[2].about.name_in_files(), "spatial standard deviation of the solid fraction");
  EXPECT_EQ(all[2].about.scale, "solid_fraction");
  EXPECT_EQ(all[3].about.name_in_files(), "fill level");
  EXPECT_EQ(all[3].about.unit, "mm");
  EXPECT_EQ(all[4].about.name_in_files(), "solid fraction of the powder");
  EXPECT_EQ(all[5].about.name, "slope of left one");
  EXPECT_EQ(all[5].about.unit, "deg");
}

/// Sources that print or draw figures of runs.
std::vector<fs::path> sources_that_show_figures() {
  std::vector<fs::path> files;
  for (const char* folder :
       {"process/compare", "process/measure", "process/results", "process/tradeoff", "render"})
    for (const auto& file : sources_in(folder))
      if (file.filename() != "figure_table.cpp") files.push_back(file);
  for (const char* name : {"tables/run_summary.cpp", "tables/comparison_table.cpp",
                           "tables/tradeoff_table.cpp", "commands/command_run.cpp"})
    files.push_back(fs::path(DIEFILL_SOURCE_DIR) / "app" / name);
  return files;
}

/// Labels as they stand in the table, with a capital, and with a unit after them. Single words mean other
/// things elsewhere.
std::set<std::string> all_labels() {
  std::set<std::string> labels;
  for (const Figure& figure : figure_table())
    for (const std::string& label : {std::string(figure.label), short_label(figure)})
      if (label.find(' ') != std::string::npos) labels.insert({label, capitalised(label)});
  return labels;
}

TEST(FigureTable, LabelsStandNowhereElse) {
  const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re"), comment("//[^\n]*");
  const auto labels = all_labels();
  for (const auto& file : sources_that_show_figures()) {
    const std::string text = std::regex_replace(text_of(file), comment, "");
    ASSERT_FALSE(text.empty()) << file;
    for (std::sregex_iterator match(text.begin(), text.end(), literal), end; match != end; ++match) {
      const std::string words = (*match)[1].str();
      std::string before_unit = words.substr(0, words.find_first_of("[,:"));
      before_unit.erase(before_unit.find_last_not_of(' ') + 1);
      EXPECT_FALSE(labels.contains(words) || labels.contains(before_unit)) << file << ": " << words;
    }
  }
}

/// The line of a figure on the figures' page.
std::string line_of(const Figure& figure) {
  const std::string also = figure.other_name == nullptr ? "" : std::string(" (`") + figure.other_name + "`)";
  return std::string("| `") + figure.name + '`' + also + " | " + figure.unit + " | " + figure.meaning +
         " | " + figure.label + " | " + figure.shown.unit + " |\n";
}

TEST(FigureTable, StandsOnTheFiguresPage) {
  std::string table = "| figure | unit | meaning | label | shown in |\n|---|---|---|---|---|\n";
  for (const Figure& figure : figure_table()) table += line_of(figure);
  const std::string page = text_of(fs::path(DIEFILL_SOURCE_DIR) / "process/results/figures.md");
  EXPECT_NE(page.find(table), std::string::npos) << "the page's table is to read\n" << table;
  EXPECT_EQ(page.find("| `", page.find(table) + table.size()), std::string::npos) << "lines beyond the table";
}

}  // namespace
}  // namespace diefill::results
