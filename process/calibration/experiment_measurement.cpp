// A quantity of an experiment of the laboratory, such as the solid fraction of settled powder: its runs with
// the starting powder, and its evaluation of them.
#include <algorithm>
#include <filesystem>
#include <map>

#include "process/calibration/measurement.h"
#include "process/calibration/possible_figures.h"
#include "process/calibration/starting_powder.h"
#include "process/input/nearest_key.h"
#include "process/input/unit_conversion.h"
#include "process/laboratory/published/lab_folder.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/published_figure.h"
#include "process/measured_data/known_fields.h"
#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

using laboratory::LabPlan;
using laboratory::LabQuantity;
using laboratory::LabSize;
using laboratory::SceneExperiment;

/// Refuses a name with the nearest one that is known, or else with all.
[[noreturn]] void refuse(const TableReader& table, const std::string& key, const std::string& word,
                         const std::string& what, const std::vector<std::string>& known) {
  if (const auto meant = nearest_key(word, known))
    table.reject(key, "no " + what + " has this name; did you mean \"" + *meant + "\"?");
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "\"" : ", \"") + name + '"';
  table.reject(key, "no " + what + " has this name; there are " + all);
}

const SceneExperiment& experiment_called(const TableReader& table, const std::string& word) {
  std::vector<std::string> known;
  for (const SceneExperiment& experiment : laboratory::scene_experiments()) {
    if (experiment.name == word) return experiment;
    known.push_back(experiment.name);
  }
  refuse(table, "experiment", word, "experiment with scenes", known);
}

/// Size, folder of scenes, and the powder that all experiments of a calibration start from.
laboratory::LabSetting read_setting(TableReader& table, const MeasurementContext& context) {
  static const Choices<LabSize> sizes = {
      {"coarse", LabSize::coarse}, {"medium", LabSize::medium}, {"published", LabSize::published}};
  laboratory::LabSetting setting;
  setting.size = table.choice("size", sizes).value_or(setting.size);
  const auto scenes = table.text("scenes");
  setting.scenes = scenes ? table.file().parent_path() / *scenes : laboratory::laboratory_folder();
  if (std::error_code unknown; !std::filesystem::exists(setting.scenes, unknown))
    table.reject(scenes ? "scenes" : "experiment",
                 "the scenes of the laboratory are not in " + setting.scenes.string() +
                     "; give their folder, such as scenes = \"/usr/share/diefill/sample_tools/laboratory\"");
  setting.powder = context.powder;
  return setting;
}

/// The plan's scene of that name; null for what an experiment computes itself.
const laboratory::LabRun* scene_run(const LabPlan& plan, const std::string& name) {
  const auto run = std::find_if(plan.runs.begin(), plan.runs.end(),
                                [&](const laboratory::LabRun& one) { return one.name == name; });
  return run == plan.runs.end() ? nullptr : &*run;
}

/// Whether a quantity follows from scenes alone.
bool takes_scenes(const LabQuantity& quantity, const LabPlan& plan) {
  return !quantity.runs.empty() &&
         std::all_of(quantity.runs.begin(), quantity.runs.end(),
                     [&](const std::string& name) { return scene_run(plan, name) != nullptr; });
}

/// The quantity that the key asks for; one that takes several seeds, or no scene, is none.
const LabQuantity& quantity_called(const TableReader& table, const LabPlan& plan, const std::string& word) {
  std::vector<std::string> known;
  for (const LabQuantity& quantity : plan.quantities) {
    if (quantity.over_seeds || !takes_scenes(quantity, plan)) continue;
    if (quantity.id == word) return quantity;
    known.push_back(quantity.id);
  }
  refuse(table, "quantity", word, "quantity of this experiment", known);
}

/// What the quantity is called and its unit, of the published figure where the quantity itself says neither.
struct About {
  std::string words, unit;
};

About about(const LabQuantity& quantity, const laboratory::LabSetting& setting) {
  About about{quantity.quantity, quantity.unit};
  if (about.words.empty() || about.unit.empty())
    for (const auto& figure :
         laboratory::read_published_figures(setting.scenes / laboratory::kPublishedFigures)) {
      if (figure.id != quantity.id) continue;
      if (about.words.empty()) about.words = figure.quantity;
      if (about.unit.empty()) about.unit = figure.unit;
    }
  if (about.words.empty()) about.words = quantity.id;
  if (about.unit.empty()) about.unit = std::string("1");
  return about;
}

double factor_into(const TableReader& table, const std::string& unit, const std::string& measured) {
  try {
    return unit_factor(unit, measured);
  } catch (const UnitError& error) {
    throw SceneError(table.where("quantity") + ": measured in \"" + measured + "\", but the quantity has \"" +
                     unit + "\": " + error.what());
  }
}

/// kg/m^3 of the metal of the setting's powder; 0: not known.
double solid_density_of(const laboratory::LabSetting& setting) {
  constexpr const char* kPreset = "Distaloy AE";  // where the setting has no powder
  return laboratory::lab_powder(setting, kPreset, setting.scale()).solid_density;
}

/// The scenes of the quantity's runs, in its order. What the plan changes stands above the starting powder: a
/// friction or a modulus that the experiment varies is its own.
std::vector<MeasurementRun> runs_of(const LabQuantity& quantity, const LabPlan& plan,
                                    const laboratory::LabSetting& setting, const std::string& set) {
  std::vector<MeasurementRun> runs;
  for (const std::string& name : quantity.runs) {
    const laboratory::LabRun& run = *scene_run(plan, name);
    const std::filesystem::path file = setting.scenes / run.scene;
    SceneChanges changes = run.changes;
    changes.source = "experiment \"" + name + '"';
    const Scene scene = changed_scene(with_starting_powder(file, setting.powder), file, changes);
    runs.push_back({with_starting_powder(scene.text, file, {}), file, set});
  }
  return runs;
}

}  // namespace

Measurement read_experiment_measurement(TableReader& table, const MeasurementContext& context) {
  const SceneExperiment& experiment =
      experiment_called(table, table.required_text("experiment", "mean_fractions"));
  const laboratory::LabSetting setting = read_setting(table, context);
  const LabPlan plan = experiment.plan(setting);
  if (plan.runs.empty())
    table.reject("experiment", "this experiment runs no scenes, which take a powder; choose one that does");
  if (!laboratory::takes_own_powder(plan))
    table.reject("experiment", "this experiment has powders of its own; choose one that takes any powder");
  const LabQuantity& quantity = quantity_called(table, plan, table.required_text("quantity", "settled"));
  const About named = about(quantity, setting);
  Measurement measurement;
  measurement.quantity = named.words;
  measurement.experiment = experiment.name;
  measurement.data = read_measured(table, 0);
  if (measurement.data.size() != 1) table.reject("file", "a quantity of an experiment has one row");
  measurement.runs = runs_of(quantity, plan, setting, set_of(table, context));
  const double factor = factor_into(table, named.unit, measurement.data.value.unit);
  refuse_impossible(measurement.data, possible_values_of_experiment(quantity.id, named.words, named.unit,
                                                                    solid_density_of(setting)));
  measurement.simulated = [factor, quantity](const std::vector<FinishedRun>& runs) {
    std::map<std::string, std::filesystem::path> folders;
    for (std::size_t k = 0; k < runs.size(); ++k) folders[quantity.runs[k]] = runs[k].folder;
    return std::vector{factor * quantity.value(laboratory::SeedResults(0, folders))};
  };
  return measurement;
}

}  // namespace diefill::process::calibration
