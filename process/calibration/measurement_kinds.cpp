#include <algorithm>

#include "process/calibration/measurement.h"
#include "process/calibration/starting_powder.h"
#include "process/input/scene_error.h"

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
    table.finish();
    all.push_back(std::move(measurement));
  }
  if (std::none_of(all.begin(), all.end(), [](const Measurement& each) { return each.fitted; }))
    document.reject("measurement", "expected at least one [[measurement]] with use = \"fit\"");
  return all;
}

MeasurementRun run_of_scene(TableReader& measurement, const MeasurementContext& context) {
  const std::filesystem::path file =
      measurement.file().parent_path() / measurement.required_text("scene", "heap.toml");
  return {with_starting_powder(file, context.powder), file, set_of(measurement)};
}

std::string set_of(TableReader& measurement) {
  std::string set;
  for (const std::string& line : measurement.texts("set", "step.1.velocity = '0.2 m/s'")) set += line + '\n';
  return set;
}

}  // namespace diefill::process::calibration
