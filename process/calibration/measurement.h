// A measurement of a plant and how it is had from simulations. A kind of measurement, such as a figure of a
// scene, is one file with a function like read_figure_measurement and its line in measurement_kinds.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/measured_data/measured_table.h"
#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process::calibration {

/// One run that a measurement takes, for one set of parameters and one seed.
struct MeasurementRun {
  std::string text;            ///< scene file with the starting powder
  std::filesystem::path file;  ///< that it is read from; stands in messages, resolves paths
  std::string set;             ///< TOML that this run changes besides the parameters; empty: nothing
};

/// A run that is finished.
struct FinishedRun {
  std::filesystem::path folder;
  const results::FillResult* result;
};

struct Measurement {
  std::string name;
  std::string kind;                  ///< such as "figure"
  bool fitted = true;                ///< false: kept for checking
  std::string quantity;              ///< what is measured, for people
  std::string figure, figure_place;  ///< its name and where the file has it; empty: no figure of a scene
  std::string experiment;            ///< of the laboratory; empty: a scene of the plant's own
  MeasuredTable data;
  std::vector<MeasurementRun> runs;
  /// The measured values as the results of `runs` have them, in the data's unit, NaN where one has none.
  /// Throws SceneError where the results can have no such value, results::ResultError where these lack it.
  std::function<std::vector<double>(const std::vector<FinishedRun>&)> simulated;

  /// Whether it is a curve: one place for each value.
  bool is_curve() const { return data.places.size() == 1; }
};

/// What the reader of a kind needs to know.
struct MeasurementContext {
  std::filesystem::path
      powder;  ///< scene or powder file that every run takes its powder from; empty: its own
  std::vector<std::string> parameters = {};  ///< keys that are to be found
};

/// Reads the keys of its kind in a [[measurement]]; name, kind and use have been read. Throws SceneError.
using ReadMeasurement = Measurement (*)(TableReader&, const MeasurementContext&);

struct MeasurementKind {
  const char* word;     ///< as `kind` names it
  const char* meaning;  ///< in a line, for help
  ReadMeasurement read;
};

/// All kinds, the usual one first.
const std::vector<MeasurementKind>& measurement_kinds();

/// All [[measurement]] tables. Throws SceneError, also for two of one name and where none is to be fitted.
std::vector<Measurement> read_measurements(TableReader& document, const MeasurementContext& context);

/// `scene` of a measurement: the text with the starting powder in place of its own. Throws SceneError, for a
/// fault that the scene file has by itself with its line there.
MeasurementRun run_of_scene(TableReader& measurement, const MeasurementContext& context);
/// Tries one line of TOML on the run's scene. Throws SceneError for a fault that it makes, named at `where`,
/// the key of the calibration file that it comes from.
void try_assignment(const MeasurementRun& run, const std::string& assignment, const std::string& where);
/// `set` of a measurement, lines of TOML. Throws SceneError where it gives a value to a parameter that is to
/// be found.
std::string set_of(TableReader& measurement, const MeasurementContext& context);
/// Throws SceneError where lines of TOML under `key` of a measurement, such as "over", give a value to a
/// parameter that is to be found.
void refuse_parameters(const TableReader& measurement, const std::string& key, const std::string& lines,
                       const MeasurementContext& context);

/// The kinds.
Measurement read_figure_measurement(TableReader& table, const MeasurementContext& context);
Measurement read_profile_measurement(TableReader& table, const MeasurementContext& context);
Measurement read_map_measurement(TableReader& table, const MeasurementContext& context);
Measurement read_experiment_measurement(TableReader& table, const MeasurementContext& context);

}  // namespace diefill::process::calibration
