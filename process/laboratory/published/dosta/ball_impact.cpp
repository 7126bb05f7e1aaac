// A steel ball that falls at 5 m/s into beds of 25,000 and 50,000 spheres (Dosta et al. 2024, case 3), from
// the published packings and with the published grains. The coarse size has twice the published step and
// begins when the ball, in free fall until then, is half a millimetre above the bed at rest; it ends, as the
// medium one, once the ball has passed its lowest place.
#include <algorithm>
#include <cmath>

#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kStart = 0.06, kFloor = -0.0802431;  // m, ball's centre: at the start, on the floor
constexpr double kSpeed = 5, kGravity = engine::kStandardGravity;  // m/s, m/s^2

struct Bed {
  int grains;
  const char* depth_id;
  const char* time_id;
  double shortest;   ///< s, by which the ball has passed its lowest place
  double above_bed;  ///< m, ball's centre when it is half a millimetre above the highest grain
};
constexpr Bed kBeds[] = {{25000, "DOS-I25", "DOS-I25-t", 0.036, -0.0450},
                         {50000, "DOS-I50", "DOS-I50-t", 0.052, -0.0117}};

std::string run_name(const Bed& bed) {
  return std::to_string(bed.grains) + " grains";
}

/// m/s, down, and s: of the ball in free fall above the bed.
double speed_above(const Bed& bed) {
  return std::sqrt(kSpeed * kSpeed + 2 * kGravity * (kStart - bed.above_bed));
}
double time_above(const Bed& bed) {
  return (speed_above(bed) - kSpeed) / kGravity;
}

LabRun ball_impact_run(const Bed& bed, LabSize size) {
  LabRun run{run_name(bed), "impact.toml", {}};
  std::string& set = run.changes.set;
  set += line("pour.grains_file", "\"dosta/impact_" + std::to_string(bed.grains) + ".csv\"");
  if (size == LabSize::published) return run;
  const bool coarse = size == LabSize::coarse;
  set += line("step.fall.duration", with_unit(bed.shortest - (coarse ? time_above(bed) : 0), "s"));
  if (!coarse) return run;
  set += line("numerics.time_step", "\"1 us\"");
  set += line("tool.ball.position", point_in_millimetres(0, 0, bed.above_bed));
  set += line("step.fall.velocity", "[\"0 m/s\", \"0 m/s\", \"-" + plain(speed_above(bed)) + " m/s\"]");
  set += line("step.fall.stops", "[{ direction = \"-z\", distance = " + millimetres(bed.above_bed - kFloor) +
                                     ", restitution = 0.4 }]");
  return run;
}

/// Height (m) of the ball's centre over the time since its release at 60 mm.
TimeCurve height_of_ball(const SeedResults& seed, const Bed& bed) {
  TimeCurve curve = probe_curve(seed, run_name(bed), "motion of ball", "z");
  double start = start_of_motion(seed, run_name(bed), "ball");
  if (curve.value.front() < 0.5 * (kStart + bed.above_bed)) start -= time_above(bed);
  for (double& time : curve.time) time -= start;
  return curve;
}

std::size_t lowest(const TimeCurve& curve) {
  return static_cast<std::size_t>(std::min_element(curve.value.begin(), curve.value.end()) -
                                  curve.value.begin());
}

/// m, largest distance from the mean of the other codes until the ball's lowest place.
double farthest_from_codes(const TimeCurve& curve, const std::vector<CodeCurve>& codes) {
  double farthest = 0;
  for (std::size_t k = 0; k <= lowest(curve); ++k) {
    double sum = 0;
    for (const CodeCurve& code : codes) sum += value_at(code.curve, std::max(0.0, curve.time[k]));
    farthest = std::fmax(farthest, std::abs(curve.value[k] - sum / static_cast<double>(codes.size())));
  }
  return farthest;
}

results::ExperimentChart ball_impact_chart(const Bed& bed, const LabSetting& setting,
                                           const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "ball_impact_" + std::to_string(bed.grains);
  chart.title = "Steel ball falling into " + run_name(bed);
  chart.subtitle = "Radius 10 mm, 5 m/s at 60 mm; floor of the box at -90.2 mm (Dosta et al. 2024)";
  chart.x = {.label = "Time since the release [ms]"};
  chart.y = {.label = "Height of the ball's centre [mm]"};
  const auto add = [&](const std::string& name, results::ExperimentSeries::Role role, const TimeCurve& curve,
                       double until) {
    results::ExperimentSeries series{.name = name, .role = role, .x = {}, .y = {}};
    for (std::size_t k = 0; k < curve.time.size(); ++k) {
      if (curve.time[k] > until) continue;
      series.x.push_back(1e3 * curve.time[k]);
      series.y.push_back(1e3 * curve.value[k]);
    }
    chart.series.push_back(std::move(series));
  };
  const TimeCurve here = height_of_ball(seed, bed);
  add("diefill", results::ExperimentSeries::Role::predicted, here, here.time.back());
  for (const CodeCurve& code : code_curves(setting.scenes, run_name(bed)))
    add(code.code, results::ExperimentSeries::Role::published, code.curve, here.time.back());
  return chart;
}

void add_quantities(const Bed& bed, const LabSetting& setting, LabPlan& plan) {
  const std::vector<std::string> runs = {run_name(bed)};
  plan.quantities.push_back(
      {.id = bed.depth_id, .quantity = "", .unit = "", .runs = runs, .value = [bed](const SeedResults& seed) {
         const TimeCurve curve = height_of_ball(seed, bed);
         return 1e3 * (kStart - curve.value[lowest(curve)]);
       }});
  plan.quantities.push_back(
      {.id = bed.time_id, .quantity = "", .unit = "", .runs = runs, .value = [bed](const SeedResults& seed) {
         const TimeCurve curve = height_of_ball(seed, bed);
         return 1e3 * curve.time[lowest(curve)];
       }});
  plan.quantities.push_back({.id = std::string(bed.depth_id) + "-codes",
                             .quantity = "farthest from the mean of the other codes, " + run_name(bed),
                             .unit = "mm",
                             .runs = runs,
                             .value = [bed, setting](const SeedResults& seed) {
                               return 1e3 * farthest_from_codes(height_of_ball(seed, bed),
                                                                code_curves(setting.scenes, run_name(bed)));
                             }});
}

}  // namespace

LabPlan plan_ball_impact(const LabSetting& setting) {
  LabPlan plan;
  for (const Bed& bed : kBeds) {
    plan.runs.push_back(ball_impact_run(bed, setting.size));
    add_quantities(bed, setting, plan);
  }
  plan.charts = [setting](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const Bed& bed : kBeds)
      if (seed.has(run_name(bed))) charts.push_back(ball_impact_chart(bed, setting, seed));
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
