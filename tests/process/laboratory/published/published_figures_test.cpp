// Published figures and the experiments that measure them: what stands in the tree fits together.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "process/input/scene_error.h"
#include "process/laboratory/published/family_tables.h"
#include "process/laboratory/published/fidelity.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/published_figure.h"
#include "process/laboratory/published/scene_experiment.h"
#include "process/scene/scene_text.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

std::filesystem::path scenes() {
  return std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/laboratory";
}

std::vector<PublishedFigure> all_figures() {
  return read_published_figures(scenes() / "published_figures.csv");
}

constexpr LabSize kSizes[] = {LabSize::coarse, LabSize::medium, LabSize::published};

TEST(PublishedFigures, HaveOneIdEachAndLimitsInOrder) {
  std::set<std::string> ids;
  for (const auto& figure : all_figures()) {
    EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
    EXPECT_FALSE(figure.lower > figure.upper) << figure.id;
    if (figure.kind == "value") {
      EXPECT_TRUE(figure.lower == figure.lower || figure.upper == figure.upper) << figure.id;
    }
  }
  EXPECT_EQ(ids.size(), 381U);
}

TEST(PublishedFigures, OfAnExperimentAreAllMeasuredByIt) {
  const auto figures = all_figures();
  for (const auto& experiment : scene_experiments()) {
    LabSetting setting;
    setting.scenes = scenes();
    std::set<std::string> measured;
    for (const auto& quantity : experiment.plan(setting).quantities) measured.insert(quantity.id);
    int count = 0;
    for (const auto& figure : figures) {
      if (figure.experiment != experiment.name) continue;
      ++count;
      EXPECT_TRUE(measured.contains(figure.id)) << experiment.name << " does not measure " << figure.id;
    }
    // One is of no source, three vary what others measure, the figures of five others are not in the tree.
    const std::set<std::string> without = {
        "powder_sheet", "bed_variants", "ring_oscillation", "reference_overlap", "youngs_modulus",
        "damping",      "drum",         "wall_discharge",   "disc_friction"};
    EXPECT_EQ(count > 0, !without.contains(experiment.name)) << experiment.name;
  }
}

TEST(SceneExperiments, EveryRunIsAValidSceneAtEverySize) {
  for (const auto& experiment : scene_experiments())
    for (const LabSize size : kSizes) {
      LabSetting setting;
      setting.size = size;
      setting.scenes = scenes();
      const LabPlan plan = experiment.plan(setting);
      std::set<std::string> names;
      for (const auto& run : plan.runs) {
        EXPECT_TRUE(names.insert(run.name).second) << run.name;
        const auto file = setting.scenes / run.scene;
        EXPECT_NO_THROW(changed_scene(load_scene_text(file), file, run.changes))
            << experiment.name << ", " << name_of(size) << ", " << run.name;
      }
      for (const auto& run : plan.custom_runs) EXPECT_TRUE(names.insert(run.name).second) << run.name;
      for (const auto& quantity : plan.quantities)
        for (const auto& run : quantity.runs) EXPECT_TRUE(names.contains(run)) << quantity.id << ": " << run;
    }
}

TEST(SceneExperiments, WithRunsHaveChartsFromWhateverIsFinished) {
  LabSetting setting;
  setting.scenes = scenes();
  const SeedResults nothing(1, {});
  for (const auto& experiment : scene_experiments()) {
    const LabPlan plan = experiment.plan(setting);
    if (plan.runs.empty() && plan.custom_runs.empty()) continue;
    ASSERT_TRUE(plan.charts) << experiment.name;
    EXPECT_NO_THROW(plan.charts(nothing)) << experiment.name;
  }
}

TEST(SceneExperiments, TakeAPowderOfTheUsersOwn) {
  const support::TemporaryFolder folder;
  const auto file = folder.write("mine.toml", "[powder]\npreset = \"ASC100.29 A2\"\nfriction = 0.37\n");
  LabSetting setting;
  setting.scenes = scenes();
  setting.powder = file;
  for (const char* name : {"shoe_discharge", "angle_of_repose", "mean_fractions", "fill_height"}) {
    const auto& all = scene_experiments();
    const auto one =
        std::find_if(all.begin(), all.end(), [&](const auto& experiment) { return experiment.name == name; });
    ASSERT_NE(one, all.end());
    const LabPlan plan = one->plan(setting);
    const auto scene_file = setting.scenes / plan.runs.front().scene;
    const Scene scene = changed_scene(load_scene_text(scene_file), scene_file, plan.runs.front().changes);
    EXPECT_EQ(scene.powder.model, GrainModel::A) << name;
    EXPECT_DOUBLE_EQ(scene.powder.friction, 0.37) << name;
    EXPECT_NEAR(scene.powder.grain_diameter, 1.2e-3, 1e-9) << name;  // four times its own
  }
}

const SceneExperiment& experiment_called(const std::string& name) {
  for (const auto& one : scene_experiments())
    if (one.name == name) return one;
  throw std::logic_error("no experiment " + name);
}

TEST(SceneExperiments, WithPowdersOfTheirOwnRefuseAnother) {
  const support::TemporaryFolder folder;
  LabSetting setting;
  setting.scenes = scenes();
  EXPECT_NO_THROW(require_use_of_powder(experiment_called("ring_levels"), setting));
  setting.powder = folder.write("mine.toml", "[powder]\npreset = \"ASC100.29 A2\"\n");
  EXPECT_NO_THROW(require_use_of_powder(experiment_called("mean_fractions"), setting));
  for (const char* name : {"ring_levels", "closed_forms", "wire_sawing"}) try {
      require_use_of_powder(experiment_called(name), setting);
      FAIL() << name << " took a powder that its runs do not use";
    } catch (const SceneError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(std::string("but ") + name + " has powders of its own"), std::string::npos) << said;
      EXPECT_NE(said.find("slit_flow, shoe_discharge"), std::string::npos) << said;
    }
}

TEST(PublishedFigures, AWrongLineIsNamed) {
  const support::TemporaryFolder folder;
  const auto file = folder.write("figures.csv", "id\nN01,too,few\n");
  try {
    read_published_figures(file);
    FAIL() << "a line of three fields was taken";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("figures.csv:2: found 3 fields"), std::string::npos)
        << error.what();
  }
}

TEST(Fidelity, HasARowForEveryFigureAndSaysWhyThereIsNoValue) {
  PublishedFigure met, unbuilt, cut;
  met.id = "N01", met.experiment = "mean_fractions", met.published = "0.59", met.lower = 0.575,
  met.upper = 0.605, met.kind = "value", met.unit = "1";
  unbuilt = met;
  unbuilt.id = "X99", unbuilt.experiment = "";
  cut = met;
  cut.id = "N02";
  results::LabTable coarse, medium;
  coarse.size = "coarse", medium.size = "medium";
  results::LabRow row;
  row.id = "N01", row.values = {0.58, 0.6}, row.verdict = "met";
  coarse.rows.push_back(row);
  row.id = "N02", row.values.clear(), row.verdict = "no value",
  row.reason = "1 of 1 runs not finished (budget used, or stopped)";
  coarse.rows.push_back(row);
  row.id = "N01", row.values = {}, row.reason = "1 of 2 runs not finished (budget used, or stopped)";
  medium.rows.push_back(row);
  const std::string page =
      fidelity_page({met, unbuilt, cut}, {coarse, medium}, {{"N01", "Tried: another lattice"}});
  EXPECT_NE(page.find("| N01 |  | 0.59 (0.575 to 0.605) | 0.59 +- 0.014 | met |"), std::string::npos) << page;
  EXPECT_NE(page.find("coarse, 2 seeds. Tried: another lattice"), std::string::npos) << page;
  EXPECT_NE(page.find("| X99 |  | 0.59 (0.575 to 0.605) | - | no experiment |"), std::string::npos) << page;
  EXPECT_NE(page.find("no value | - | 0 | 1 of 1 runs not finished (budget used, or stopped)"),
            std::string::npos)
      << page;
}

TEST(Fidelity, AssemblesSectionsOfASourceAndCountsVerdictsBySource) {
  PublishedFigure one, other;
  one.id = "N01", one.source = "Bierwisch 2009", one.section = "section 4.1.5",
  one.experiment = "mean_fractions";
  one.kind = "value";
  other = one;
  other.id = "U01", other.source = "Hu 2024", other.section = "box", other.experiment = "critical_step";
  PublishedFigure later = one;
  later.id = "N02";
  PublishedFigure input = other;
  input.id = "U02", input.kind = "input", input.experiment = "";
  const std::string page = fidelity_page({one, other, later, input}, {}, {});
  const std::string of_n01 = "\n| N01 |", of_n02 = "\n| N02 |";
  EXPECT_LT(page.find(of_n01), page.find(of_n02));
  EXPECT_LT(page.find(of_n02), page.find("## Hu 2024, box")) << page;
  EXPECT_NE(page.find("## Bierwisch 2009, section 4.1.5\n- `diefill lab mean_fractions`: "),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("| verdict | Bierwisch 2009 | Hu 2024 | all |"), std::string::npos) << page;
  EXPECT_NE(page.find("| not run | 2 | 1 | 3 |"), std::string::npos) << page;
  EXPECT_NE(page.find("| input | 0 | 1 | 1 |"), std::string::npos) << page;
}

TEST(Fidelity, HoldsMeasuredPowdersBesideTheirCalibratedSets) {
  PublishedFigure run, used, predicted;
  run.id = "LH220-exp-tens-1", run.setting = "powder=LH220; run=1", run.published = "0.0569";
  used.id = "LH220-exp-tens-used", used.setting = "powder=LH220; run=used", used.published = "0.0646";
  run.kind = used.kind = "input", run.quantity = used.quantity = "sigma_tens";
  predicted.id = "L220-pred-sigma_tens", predicted.published = "0.938", predicted.kind = "value";
  predicted.quantity = "sigma_tens", predicted.unit = "kPa", predicted.experiment = "confined_compression";
  results::LabTable table;
  results::LabRow row;
  row.id = predicted.id, row.values = {1.454}, row.verdict = "met";
  table.rows.push_back(row);
  const std::string page = fidelity_page({run, used, predicted}, {table}, {});
  EXPECT_NE(page.find("| LH220 | sigma_tens kPa | 0.0646 | 0.938 | 1.454 (met) |"), std::string::npos)
      << page;
}

TEST(Fidelity, NamesARunThatStopsAndLeavesItsMessageToTheTable) {
  PublishedFigure figure;
  figure.id = "N03", figure.experiment = "mean_fractions", figure.kind = "value";
  results::LabRow row;
  row.id = "N03", row.verdict = "no value";
  row.reason = "run \"A1\" failed: two spheres overlap by 0.71 of their radius by t = 0.197732 s";
  results::LabTable table;
  table.rows.push_back(row);
  const std::string page = fidelity_page({figure}, {table}, {{"N03", "Small spheres between large ones"}});
  EXPECT_NE(page.find("| run \"A1\" stops before its end (message in kept_results.csv). Small spheres"),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("0.197732"), std::string::npos) << page;
}

TEST(FamilyTables, KeepWhatAnExperimentHasOfPublishedFigures) {
  PublishedFigure figure;
  figure.id = "D01", figure.quantity = "bulk fraction", figure.unit = "1", figure.published = "0.365";
  figure.lower = 0.355, figure.upper = 0.375, figure.experiment = "flow";
  PublishedFigure other = figure;
  other.id = "D02";
  results::ExperimentResult result;
  result.name = "hopper";
  result.quick = true;
  result.cpu_seconds = 12;
  result.figures = {{"D01", 0.36, "settled", 3e-3}, {"D02", 0.4, "", 3e-3}};
  const support::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "flow");
  results::write_lab_table(folder.path() / "flow", table_of_figures(result, {figure, other}));
  const auto tables = family_tables(folder.path());
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].experiment, "hopper_figures");
  ASSERT_EQ(tables[0].rows.size(), 2U);
  EXPECT_EQ(tables[0].rows[0].verdict, "met");
  EXPECT_EQ(tables[0].rows[1].verdict, "not met");
  const std::string page = fidelity_page({figure, other}, tables, {});
  EXPECT_NE(page.find("quick, 1 seed; settled"), std::string::npos) << page;
  EXPECT_TRUE(family_tables(folder.path() / "none").empty());
}

}  // namespace
}  // namespace diefill::process::laboratory
