// A calibration of the friction of a scene whose runs tests make up: numbers in place of simulations.
#pragma once

#include <toml++/toml.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "process/calibration/fit.h"
#include "process/results/storage/result_file.h"
#include "process/scene/scene_text.h"
#include "tests/process/results_sample.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// One parameter, friction from 0.25 to 1.25, of the faultless scene.
class MadeUpCalibration {
 public:
  MadeUpCalibration() {
    // Jobs copy the tools, which no run reads here; an empty file would be refused.
    for (const char* name : {"die.stl", "shoe.stl"})
      std::ofstream(folder.path() / name) << "solid nothing\nendsolid nothing\n";
    plan.file = folder.path() / "calibration.toml";
    plan.title = "made up";
    plan.powder = folder.write(faultless_scene());
    plan.parameters = {{"powder.friction", "1", 0.25, 1.25, false}};
    plan.seeds = 1;
    plan.start_points = 6;
    plan.most_points = 10;
  }

  /// A measurement over as many speeds as there are values; `simulated` as a Measurement has it.
  Measurement& add(const std::string& name, std::vector<double> values, double deviation,
                   bool fitted = true) {
    Measurement measurement;
    measurement.name = name;
    measurement.kind = "figure";
    measurement.fitted = fitted;
    measurement.quantity = "mass";
    std::vector<double> places;
    for (std::size_t k = 0; k < values.size(); ++k) places.push_back(static_cast<double>(k + 1));
    if (values.size() > 1) measurement.data.places = {{"speed", "m/s", places, "m.csv:1:1"}};
    measurement.data.deviation = {"deviation", "g", std::vector<double>(values.size(), deviation),
                                  "m.csv:1:3"};
    measurement.data.value = {"mass", "g", std::move(values), "m.csv:1:2"};
    measurement.data.where = "m.csv";
    measurement.runs = {{faultless_scene(), plan.powder, ""}};
    plan.measurements.push_back(std::move(measurement));
    return plan.measurements.back();
  }

  SceneFolder folder;
  CalibrationPlan plan;
};

/// A point with a row of values for each measurement; an empty row: none.
inline void add_point(SimulatedPoints& simulated, const std::string& role, double place,
                      const std::vector<std::vector<double>>& rows) {
  PointOutcome outcome;
  outcome.state = "finished";
  for (const auto& row : rows) outcome.values.emplace_back(row.empty() ? 0 : 1, row);
  simulated.points.push_back({role, {place}, role != "edge", role == "best" || role == "edge"});
  simulated.outcomes.push_back(std::move(outcome));
}

/// The friction that a job's scene has.
inline double friction_of(const FinishedRun& run) {
  const auto file = run.folder / "scene.toml";
  return parse_scene_text(load_scene_text(file), file)["powder"]["friction"].value<double>().value_or(NAN);
}

/// A finished run in `folder`, whatever its scene: a copy, since writing waits for the disk.
inline void make_up_results(const std::filesystem::path& folder) {
  static const support::TemporaryFolder once;
  if (!std::filesystem::exists(once.path() / "results.h5"))
    results::write_results(once.path(), results::sample_result());
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(once.path() / "results.h5", folder / "results.h5",
                             std::filesystem::copy_options::skip_existing);
  std::ofstream(folder / "report.json") << "{}\n";
}

/// Whether one of the lines has `part` in it.
inline bool has_line(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace diefill::process::calibration
