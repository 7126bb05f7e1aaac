#include "process/calibration/input_files.h"

#include <toml++/toml.h>

#include <set>

#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

namespace fs = std::filesystem;

/// The scene, or file with a starting powder, and the powder file that it names.
void add_scene(const fs::path& scene, std::set<fs::path>& files) {
  if (scene.empty() || !files.insert(scene).second) return;
  const toml::table document = parse_scene_text(load_scene_text(scene), scene);
  if (const auto powder = document["powder"]["file"].value<std::string>())
    files.insert(scene.parent_path() / *powder);
}

}  // namespace

std::vector<fs::path> input_files(const CalibrationPlan& plan) {
  std::set<fs::path> files;
  add_scene(plan.powder, files);
  for (const Measurement& measurement : plan.measurements) {
    if (!measurement.data.lines.empty()) files.insert(measurement.data.where);
    for (const MeasurementRun& run : measurement.runs) add_scene(run.file, files);
  }
  files.insert(plan.file);
  return {files.begin(), files.end()};
}

}  // namespace diefill::process::calibration
