#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {

void add_run_series(results::ExperimentChart& chart, const SeedResults& seed, const std::string& name,
                    const std::vector<PointOfRun>& points,
                    const std::function<double(const std::string& run)>& value) {
  results::ExperimentSeries series{.name = name, .x = {}, .y = {}};
  for (const PointOfRun& point : points) {
    if (!seed.has(point.run)) continue;
    series.x.push_back(point.x);
    series.y.push_back(value(point.run));
  }
  if (!series.x.empty()) chart.series.push_back(std::move(series));
}

}  // namespace diefill::process::laboratory
