#include "process/calibration/calibration_file.h"

#include <toml++/toml.h>

#include "process/input/named_file.h"
#include "process/input/text_encoding.h"
#include "process/input/text_file.h"
#include "process/scene/scene_text.h"
#include "process/scene/setting.h"
#include "process/scene/variants.h"

namespace diefill::process::calibration {
namespace {

constexpr int kMaxSeeds = 100, kMaxPoints = 10000;

/// Every run's scene with the powder to start from: what is wrong there is not the ranges' fault.
void check_runs(const CalibrationPlan& plan, const Measurement& measurement) {
  CalibrationPlan start = plan;
  start.parameters.clear();
  try {
    for (const MeasurementRun& run : measurement.runs) scene_at(start, run, {});
  } catch (const SceneError& error) {
    throw SceneError(plan.file.string() + ": measurement \"" + measurement.name + "\": " + error.what());
  }
}

/// Names a parameter that a scene cannot have at its own end, all others as the scene has them; nothing where
/// each goes by itself.
void refuse_own_ends(const CalibrationPlan& plan, const Measurement& measurement) {
  for (const ParameterRange& range : plan.parameters)
    for (const bool lower : {true, false}) {
      try {
        try_assignment(measurement.runs.front(), range.assignment(lower ? 0 : 1),
                       lower ? range.where_from : range.where_to);
      } catch (const SceneError& error) {
        // A parameter that needs another one fails with the other's key.
        const std::string message = error.what();
        if (message.find(range.key) != std::string::npos)
          throw SceneError(message + " (measurement \"" + measurement.name + "\")");
      }
    }
}

/// The last check is to show what finer grains than those of the runs change.
void check_finer_grains(const CalibrationPlan& plan, const Measurement& measurement) {
  const MeasurementRun& run = measurement.runs.front();
  const std::vector<double> middle(plan.parameters.size(), 0.5);
  const double fitted = scene_at(plan, run, middle).powder.grain_diameter;
  const toml::table parsed = parse_scene_text(plan.text, plan.file);
  TableReader check = TableReader(parsed, plan.file, "").required_table("check");
  const auto refuse = [&] {
    check.reject("grain_diameter", "allowed: less than the " + number_text(1e3 * fitted) +
                                       " mm of measurement \"" + measurement.name +
                                       "\", since this check is with finer grains");
  };
  // Before the scene is built, which may have no room for coarse grains.
  if (check.required_quantity("grain_diameter", {Dimension::length, "0.7 mm", {}, {}}) >= fitted) refuse();
  // Presets take a diameter as one that their tables print (1.88 mm stands for 1.8816 mm).
  if (scene_at(plan, run, middle, finer_grains_of(plan)).powder.grain_diameter >= fitted) refuse();
}

/// Scenes that a run cannot have are found before hours are spent.
void check_ends(const CalibrationPlan& plan) {
  const std::size_t count = plan.parameters.size();
  for (const Measurement& measurement : plan.measurements) {
    check_runs(plan, measurement);
    const MeasurementRun& run = measurement.runs.front();
    for (std::size_t k = 0; k < count; ++k)
      for (const double end : {0.0, 1.0}) {
        std::vector<double> place(count, 0.5);
        place[k] = end;
        try {
          if (setting_of(scene_at(plan, run, place)))
            throw SceneError(run.file.string() +
                             ": setting: a calibration needs numbers; write grain_diameter instead");
        } catch (const SceneError& error) {
          refuse_own_ends(plan, measurement);
          throw SceneError(std::string(error.what()) + " (measurement \"" + measurement.name + "\", " +
                           plan.parameters[k].key + " at " + (end == 0 ? "\"from\"" : "\"to\"") + ")");
        }
      }
  }
  if (!plan.finer_grains.empty())
    for (const Measurement& measurement : plan.measurements) check_finer_grains(plan, measurement);
}

std::string load_calibration_text(const std::filesystem::path& file) {
  const TextFileKind kind = {"calibration file",
                             "but a calibration is a short TOML file; did you pass a table or a result?",
                             std::size_t{4} << 20U};
  try {
    std::string text = load_text_file(file, kind);
    refuse_wrong_encoding(text, file, TextKind::calibration);
    return text;
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& reason) {
    throw SceneError(file.string() + ": " + reason.what() +
                     "; give a calibration file, such as sample_tools/calibration/my_powder.toml");
  }
}

void read_search(TableReader& document, CalibrationPlan& plan) {
  const int count = static_cast<int>(plan.parameters.size());
  plan.start_points = 4 + 4 * count;
  plan.most_points = 10 + 15 * count;
  if (auto search = document.table("search")) {
    plan.seeds = static_cast<int>(search->integer("seeds", 1, kMaxSeeds).value_or(plan.seeds));
    plan.start_points =
        static_cast<int>(search->integer("start_points", count + 2, kMaxPoints).value_or(plan.start_points));
    plan.most_points = static_cast<int>(search->integer("most_points", plan.start_points, kMaxPoints)
                                            .value_or(std::max(plan.most_points, plan.start_points)));
    plan.points_at_once =
        static_cast<int>(search->integer("points_at_once", 1, kMaxPoints).value_or(plan.points_at_once));
    search->finish();
  }
  if (auto check = document.table("check")) {
    plan.finer_grains = check->required_text("grain_diameter", "0.7 mm");
    check->finish();
  }
  if (auto screening = document.table("screening")) {
    plan.resolution = static_cast<int>(screening->integer("resolution", 3, 5).value_or(plan.resolution));
    screening->finish();
  }
}

}  // namespace

void check_enough_data(const CalibrationPlan& plan) {
  std::size_t data = 0;
  for (const Measurement& measurement : plan.measurements)
    if (measurement.fitted) data += measurement.data.size();
  if (data < plan.parameters.size())
    throw SceneError(
        plan.file.string() + ": found " + std::to_string(data) +
        (data == 1 ? " measured value to fit " : " measured values to fit ") +
        std::to_string(plan.parameters.size()) +
        " parameters; allowed: at least as many values as parameters; measure more or remove parameters");
}

std::string finer_grains_of(const CalibrationPlan& plan) {
  return "powder.grain_diameter = \"" + plan.finer_grains + "\"\n";
}

CalibrationPlan read_calibration(const std::filesystem::path& file) {
  CalibrationPlan plan;
  plan.file = file;
  plan.text = load_calibration_text(file);
  const toml::table parsed = parse_scene_text(plan.text, file);
  TableReader document(parsed, file, "");
  plan.title = document.text("title").value_or(file.stem().string());
  plan.seed = static_cast<std::uint64_t>(document.integer("seed", 0, INT64_MAX / 2).value_or(1));
  plan.parameters = read_parameters(document);
  if (document.has("powder")) plan.powder = named_file(document, "powder", "powder.toml");
  const auto tables = document.tables("measurement");
  if (plan.powder.empty() && !tables.empty()) {
    TableReader first = tables.front();
    if (first.has("experiment")) document.require("powder", "\"powder.toml\", or a scene with the powder");
    plan.powder = named_file(first, "scene", "heap.toml");
  }
  MeasurementContext context{plan.powder};
  for (const ParameterRange& range : plan.parameters) context.parameters.push_back(range.key);
  plan.measurements = read_measurements(document, context);
  read_search(document, plan);
  document.finish();
  check_ends(plan);
  return plan;
}

Scene scene_at(const CalibrationPlan& plan, const MeasurementRun& run, const std::vector<double>& place,
               const std::string& set) {
  SceneChanges changes;
  changes.source = plan.file.string() + ": set and parameters";
  changes.set = run.set + (run.set.empty() || run.set.back() == '\n' ? "" : "\n");
  for (std::size_t k = 0; k < place.size(); ++k) changes.set += plan.parameters[k].assignment(place[k]);
  const Scene scene = changed_scene(run.text, run.file, changes);
  if (set.empty()) return scene;
  SceneChanges last;
  last.source = plan.file.string() + ": check.grain_diameter";
  last.set = set;
  return changed_scene(scene.text, run.file, last);
}

}  // namespace diefill::process::calibration
