#include "process/laboratory/published/dosta/bulk_curves.h"

#include <algorithm>

#include "process/laboratory/published/csv_rows.h"
#include "process/measure/figures/line_fit.h"
#include "process/results/none.h"
#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory {
std::vector<CodeCurve> code_curves(const std::filesystem::path& scenes, const std::string& name) {
  const std::filesystem::path file = scenes / "dosta/curves.csv";
  std::vector<CodeCurve> curves;
  // case, code, time, value
  for_each_row(file, 4, MissingFile::error, [&](const auto& fields, const auto& where) {
    if (fields[0] != name) return;
    if (curves.empty() || curves.back().code != fields[1]) curves.push_back({fields[1], {}});
    curves.back().curve.time.push_back(number_in(fields[2], where));
    curves.back().curve.value.push_back(number_in(fields[3], where));
  });
  return curves;
}

TimeCurve probe_curve(const SeedResults& seed, const std::string& run, const std::string& probe,
                      const std::string& column) {
  for (const results::ProbeSeries& series : seed.of(run).probes) {
    const auto found = std::find(series.columns.begin(), series.columns.end(), column);
    if (series.name != probe || found == series.columns.end()) continue;
    const std::size_t width = series.columns.size(),
                      place = static_cast<std::size_t>(found - series.columns.begin());
    TimeCurve curve;
    for (std::size_t k = 0; k < series.values.size(); k += width) {
      curve.time.push_back(series.values[k]);
      curve.value.push_back(series.values[k + place]);
    }
    return curve;
  }
  throw results::ResultError("run \"" + run + "\": the results have no \"" + column + "\" of probe \"" +
                             probe + '"');
}

double start_of_motion(const SeedResults& seed, const std::string& run, const std::string& tool) {
  for (const auto& stage : seed.of(run).stages)  // of several tools: "shoe, lid"
    if ((", " + stage.tool + ", ").find(", " + tool + ", ") != std::string::npos) return stage.start;
  throw results::ResultError("run \"" + run + "\": tool \"" + tool + "\" has not moved");
}

double slope_of(const TimeCurve& curve, double from, double to) {
  constexpr double kRounding = 1e-9;  // s
  std::vector<double> time, value;
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    if (curve.time[k] < from - kRounding || curve.time[k] > to + kRounding) continue;
    time.push_back(curve.time[k]);
    value.push_back(curve.value[k]);
  }
  return fit_line(time, value).slope;
}

double value_at(const TimeCurve& curve, double time) {
  for (std::size_t k = 1; k < curve.time.size(); ++k) {
    if (time < curve.time[k - 1] || time > curve.time[k]) continue;
    const double share = (time - curve.time[k - 1]) / (curve.time[k] - curve.time[k - 1]);
    return curve.value[k - 1] + share * (curve.value[k] - curve.value[k - 1]);
  }
  return kNone;
}

}  // namespace diefill::process::laboratory
