#include <toml++/toml.h>

#include <algorithm>
#include <cctype>

#include "process/calibration/key_node.h"
#include "process/calibration/measurement.h"
#include "process/calibration/starting_powder.h"
#include "process/input/named_file.h"
#include "process/input/scene_error.h"
#include "process/scene/scene_text.h"
#include "process/scene/variants.h"

namespace diefill::process::calibration {

namespace {

/// More values are no more information where neighbours are averages over the same powder, and their
/// covariances take time and memory.
void refuse_too_many(const Measurement& measurement) {
  constexpr std::size_t kMost = 1000;
  if (measurement.data.size() > kMost)
    throw SceneError(measurement.data.where + ": found " + std::to_string(measurement.data.size()) +
                     " values of \"" + measurement.name + "\", allowed: at most " + std::to_string(kMost) +
                     " with use = \"fit\"; average on a coarser grid, no finer than the averaging width");
}

/// A message about a scene without line and column after the file's name.
std::string without_place(std::string message, const std::filesystem::path& file) {
  const std::string start = file.string() + ':';
  if (!message.starts_with(start)) return message;
  std::size_t end = start.size();
  for (int number = 0; number < 2; ++number) {  // line, column
    std::size_t behind = end;
    while (behind < message.size() && std::isdigit(static_cast<unsigned char>(message[behind])) != 0)
      ++behind;
    if (behind == end || behind == message.size() || message[behind] != ':') return message;
    end = behind + 1;
  }
  return message.erase(start.size(), end - start.size());
}

/// A run's text has other lines than its file, since the starting powder is put into it: what is wrong with
/// the file itself is named where it stands there.
void check_scene(const MeasurementRun& run, const std::string& as_written, const std::string& where_set,
                 const std::filesystem::path& powder) {
  SceneChanges changes;
  changes.set = run.set;
  changes.source = where_set;
  std::string fault;
  try {
    changed_scene(run.text, run.file, changes);
    return;
  } catch (const SceneError& error) {
    fault = without_place(error.what(), run.file);
  }
  try {
    changed_scene(as_written, run.file, changes);
  } catch (const SceneError& error) {
    if (without_place(error.what(), run.file) == fault) throw;
  }
  throw SceneError(fault + " (with the powder and walls of " + powder.string() + ')');
}

bool same_run(const MeasurementRun& one, const MeasurementRun& other) {
  return one.text == other.text && one.set == other.set;
}

/// Whether both take the same number of the same run. What the simulations do not know would count twice.
bool repeats(const Measurement& one, const Measurement& other) {
  if ((one.kind != "figure" && one.kind != "experiment") || !(one.fitted && other.fitted)) return false;
  if (one.kind != other.kind || one.quantity != other.quantity || one.figure != other.figure ||
      one.experiment != other.experiment)
    return false;
  return std::any_of(one.runs.begin(), one.runs.end(), [&](const MeasurementRun& run) {
    return std::any_of(other.runs.begin(), other.runs.end(),
                       [&](const MeasurementRun& earlier) { return same_run(run, earlier); });
  });
}

void refuse_repeated(const TableReader& table, const Measurement& measurement,
                     const std::vector<Measurement>& earlier) {
  const auto same = std::find_if(earlier.begin(), earlier.end(),
                                 [&](const Measurement& other) { return repeats(measurement, other); });
  if (same != earlier.end())
    table.reject("name",
                 "measurement \"" + same->name +
                     "\" is of the same run and the same quantity, which would count twice; give both as "
                     "one, with their mean and its deviation, or set use = \"check\" in one");
}

}  // namespace

const std::vector<MeasurementKind>& measurement_kinds() {
  static const std::vector<MeasurementKind> kinds = {
      {"figure", "a figure of a scene, alone or over a key of the scene", read_figure_measurement},
      {"profile", "a profile of a scene's result, such as the fill level over the azimuth",
       read_profile_measurement},
      {"map", "a map or section of a scene's result", read_map_measurement},
      {"experiment", "a quantity of an experiment of the laboratory", read_experiment_measurement},
  };
  return kinds;
}

std::vector<Measurement> read_measurements(TableReader& document, const MeasurementContext& context) {
  Choices<ReadMeasurement> kinds;
  for (const MeasurementKind& kind : measurement_kinds()) kinds.emplace_back(kind.word, kind.read);
  static const Choices<bool> uses = {{"fit", true}, {"check", false}};
  document.require("measurement", "a [[measurement]] with name, scene, figure, value and deviation");
  std::vector<Measurement> all;
  for (TableReader& table : document.tables("measurement")) {
    const std::string name = table.required_name("name", "heap");
    const auto same = [&](const Measurement& other) { return other.name == name; };
    if (std::any_of(all.begin(), all.end(), same))
      table.reject("name", "an earlier measurement has this name; give each a unique name");
    const std::string kind = table.text("kind").value_or(kinds.front().first);
    const ReadMeasurement read = table.choice("kind", kinds).value_or(kinds.front().second);
    const bool fitted = table.choice("use", uses).value_or(true);
    Measurement measurement = read(table, context);
    measurement.name = name;
    measurement.kind = kind;
    measurement.fitted = fitted;
    if (fitted) refuse_too_many(measurement);
    refuse_repeated(table, measurement, all);
    table.finish();
    all.push_back(std::move(measurement));
  }
  if (std::none_of(all.begin(), all.end(), [](const Measurement& each) { return each.fitted; }))
    document.reject("measurement", "expected at least one [[measurement]] with use = \"fit\"");
  return all;
}

MeasurementRun run_of_scene(TableReader& measurement, const MeasurementContext& context) {
  const std::filesystem::path file = named_file(measurement, "scene", "heap.toml");
  const std::string as_written = load_scene_text(file);
  MeasurementRun run{with_starting_powder(as_written, file, context.powder), file,
                     set_of(measurement, context)};
  check_scene(run, as_written, measurement.where("set"), context.powder);
  return run;
}

void try_assignment(const MeasurementRun& run, const std::string& assignment, const std::string& where) {
  SceneChanges set;
  set.set = run.set;
  const std::string text = changed_scene(run.text, run.file, set).text;
  SceneChanges one;
  one.set = assignment;
  one.source = where;
  try {
    changed_scene(text, run.file, one);
  } catch (const SceneError& error) {
    const std::string message = error.what(), of_change = where + ", change 1: ";
    throw SceneError(where + ": " +
                     (message.starts_with(of_change) ? message.substr(of_change.size())
                                                     : without_place(message, run.file)));
  }
}

std::string set_of(TableReader& measurement, const MeasurementContext& context) {
  std::string set;
  for (const std::string& line : measurement.texts("set", "step.1.velocity = '0.2 m/s'")) set += line + '\n';
  refuse_parameters(measurement, "set", set, context);
  return set;
}

void refuse_parameters(const TableReader& measurement, const std::string& key, const std::string& lines,
                       const MeasurementContext& context) {
  const std::string where = measurement.where(key);
  const toml::table given = parse_changes(lines, where);
  for (const std::string& parameter : context.parameters)
    if (node_of_key(given, parameter) != nullptr)
      throw SceneError(where + ": " + parameter +
                       " is a [[parameter]] of this calibration, which gives it a value in each run; choose "
                       "another key here, or remove the [[parameter]]");
}

}  // namespace diefill::process::calibration
