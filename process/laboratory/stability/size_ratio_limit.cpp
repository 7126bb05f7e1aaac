// Friction between grains of very unequal size: a fine sphere in the groove between two large ones, which
// falls out of it, or is held fast where friction is wrong.
#include <cmath>
#include <numbers>
#include <string>

#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/rolling_in_groove.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kDegree = std::numbers::pi / 180, kHalfway = 30;  // degrees
constexpr double kFallen = 1.6;  // times to kHalfway after which it has left the groove, or never will
constexpr double kStep = 1e-6;   // s

GrooveCase groove_of(double ratio) {
  return {.ratio = ratio, .start = kDegree};
}

double time_to_halfway(double ratio) {
  return rolling_time(groove_of(ratio), kHalfway * kDegree);
}

results::ExperimentChart falling_chart(const std::vector<double>& ratios) {
  results::ExperimentChart chart;
  chart.name = "size_ratio";
  chart.title = "Position of a fine sphere that should fall from between two large ones";
  chart.subtitle = "Steps of 1 us, a thirteenth of a collision; friction 0.5";
  chart.note = "Distance 1: still in the groove. Above a ratio of about 45 friction alone holds it.";
  chart.x = {.label = "Ratio of the radii", .logarithmic = true};
  chart.y = {.label = "Distance from the groove's middle", .logarithmic = true, .lower = 0.5, .upper = 20};
  ExperimentSeries engine{.name = "measured", .x = ratios, .y = {}};
  ExperimentSeries half{.name = "velocities half a step old", .x = ratios, .y = {}};
  ExperimentSeries fine{.name = "a quarter of the step", .role = Role::predicted, .x = ratios, .y = {}};
  for (const double ratio : ratios) {
    const double time = kFallen * time_to_halfway(ratio);
    engine.y.push_back(place_by_engine(groove_of(ratio), time, kStep).distance);
    half.y.push_back(place_by_half_steps(groove_of(ratio), time, kStep).distance);
    fine.y.push_back(place_by_engine(groove_of(ratio), time, 0.25 * kStep).distance);
  }
  chart.series = {engine, half, fine};
  return chart;
}

}  // namespace

void find_size_ratio_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const std::vector<double> ratios =
      options.quick ? std::vector<double>{1, 3, 7, 10, 20, 40}
                    : std::vector<double>{1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50, 70, 100};
  const auto chart = falling_chart(ratios);
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const std::string ratio = "ratio " + std::to_string(std::lround(ratios[k]));
    result.limits.push_back(
        {ratio + ": angle of a fine sphere that rolls down between two large ones",
         place_by_engine(groove_of(ratios[k]), time_to_halfway(ratios[k]), kStep).angle / kDegree, kHalfway,
         "degrees", "rolling without slipping"});
    result.limits.push_back({ratio + ": distance from the groove when it should have fallen",
                             chart.series[0].y[k], chart.series[2].y[k], "1", "a quarter of the step"});
    result.limits.push_back({ratio + ": the same with velocities half a step old", chart.series[1].y[k],
                             chart.series[2].y[k], "1", "a quarter of the step"});
  }
  result.charts = {chart};
}

}  // namespace diefill::process::laboratory
