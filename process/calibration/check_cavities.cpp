#include "process/calibration/check_cavities.h"

#include <charconv>
#include <limits>
#include <map>

#include "process/input/scene_error.h"
#include "process/results/cavity_rows.h"
#include "process/results/word_list.h"
#include "process/setup/read_tooling.h"

namespace diefill::process::calibration {
namespace {

constexpr std::string_view kFurtherCavity = "cavity_";
constexpr std::size_t kMaxNames = 6;  // that a message lists

/// A figure's name in two: "cavity_3_fill_ratio" is "fill_ratio" of cavity 3.
struct CavityFigure {
  std::size_t cavity = 1;
  std::string name;
};

CavityFigure cavity_figure(const std::string& figure) {
  if (!figure.starts_with(kFurtherCavity)) return {1, figure};
  std::size_t number = 0;
  const char* const end = figure.data() + figure.size();
  const auto read = std::from_chars(figure.data() + kFurtherCavity.size(), end, number);
  if (read.ptr == end || *read.ptr != '_') return {1, figure};  // such as cavity_volume_m3
  if (read.ec == std::errc::result_out_of_range) number = std::numeric_limits<std::size_t>::max();
  return {number, std::string(read.ptr + 1, end)};
}

/// 0: not known before the run.
std::size_t cavities_of(const Scene& scene, const ProgressCallback& on_progress) {
  const Tooling tooling = read_tooling(scene, on_progress);
  return tooling.cavity.found ? 1 + tooling.other_cavities.size() : 0;
}

[[noreturn]] void refuse(const Measurement& measurement, const std::string& name, std::size_t cavities) {
  std::vector<std::string> allowed;
  for (std::size_t n = 1; n <= cavities; ++n)
    allowed.push_back('"' + results::figure_prefix(static_cast<int>(n)) + name + '"');
  throw SceneError(measurement.figure_place + ": found \"" + measurement.figure + "\", but the die has " +
                   (cavities == 1 ? "one cavity" : std::to_string(cavities) + " cavities") +
                   ", allowed: " + results::comma_list(allowed, kMaxNames, " or "));
}

}  // namespace

void check_cavities(const CalibrationPlan& plan, const ProgressCallback& on_progress) {
  std::map<std::string, std::size_t> known;  // by scene: several measurements may share one
  for (const Measurement& measurement : plan.measurements) {
    const auto [cavity, name] = cavity_figure(measurement.figure);
    if (cavity < 2) continue;
    const MeasurementRun& run = measurement.runs.front();
    const auto [cavities, is_new] = known.emplace(run.file.string() + '\n' + run.set, 0);
    if (is_new) cavities->second = cavities_of(scene_at(plan, run, {}), on_progress);
    if (cavities->second > 0 && cavity > cavities->second) refuse(measurement, name, cavities->second);
  }
}

}  // namespace diefill::process::calibration
