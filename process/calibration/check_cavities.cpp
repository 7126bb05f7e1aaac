#include "process/calibration/check_cavities.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "process/calibration/scene_figures.h"
#include "process/compare/check_measured.h"
#include "process/input/scene_error.h"
#include "process/measured_data/fields_of_shape.h"
#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "process/results/word_list.h"

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

void refuse_other_cavities(const Measurement& measurement, const CavityFigure& figure, std::size_t cavities) {
  if (figure.cavity <= cavities) return;
  std::vector<std::string> allowed;
  for (std::size_t n = 1; n <= cavities; ++n)
    allowed.push_back('"' + results::figure_prefix(static_cast<int>(n)) + figure.name + '"');
  throw SceneError(measurement.figure_place + ": found \"" + measurement.figure + "\", " +
                   but_the_die_has(cavities) +
                   ", allowed: " + results::comma_list(allowed, kMaxNames, " or "));
}

void refuse_figure(const Scene& scene, const Measurement& measurement, const CavityFigure& figure,
                   const std::vector<bool>& rings) {
  if (!rings.empty()) refuse_other_cavities(measurement, figure, rings.size());
  const results::Figure* known = results::find_figure(figure.name);
  if (known == nullptr) return;
  if (const auto reason = why_cavity_has_no(scene, known->name, figure.cavity, rings))
    throw SceneError(measurement.figure_place + ": found \"" + measurement.figure + "\", " + *reason);
}

/// Whether the cavities decide if results have the figure.
bool is_to_be_checked(const Scene& scene, const CavityFigure& figure) {
  if (figure.cavity > 1) return true;
  const results::Figure* known = results::find_figure(figure.name);
  return known != nullptr && depends_on_cavity(scene, known->name);
}

}  // namespace

void check_cavities(const CalibrationPlan& plan, const ProgressCallback& on_progress) {
  std::map<std::string, std::vector<bool>> known;  // by scene: several measurements may share one
  for (const Measurement& measurement : plan.measurements) {
    const bool field = measurement.kind == "profile" || measurement.kind == "map";
    const CavityFigure figure = cavity_figure(measurement.figure);
    const MeasurementRun& run = measurement.runs.front();
    const Scene scene = scene_at(plan, run, {});
    if (!field && !is_to_be_checked(scene, figure)) continue;
    const auto [rings, is_new] = known.emplace(run.file.string() + '\n' + run.set, std::vector<bool>());
    if (is_new) rings->second = rings_of(scene, on_progress);
    if (!field)
      refuse_figure(scene, measurement, figure, rings->second);
    else if (!rings->second.empty())
      refuse_field_of_other_shape(measurement.data, measurement.quantity, rings->second);
  }
}

}  // namespace diefill::process::calibration
