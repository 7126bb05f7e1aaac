// The largest time step at which colliding spheres keep their energy, for three enlargements (Hu 2024,
// section 4.4): spheres without damping, friction and gravity in a box with periods along y and z and smooth
// elastic walls along x. With lengths, times and steps all l times as large the runs are the same, so that
// the critical step is proportional to l. Two criteria: kinetic and elastic energy together, and kinetic
// energy alone as in the source, which fluctuates with what contacts hold. Coarse: boxes of 10 d, 0.05 s l;
// medium: 20 d, 0.1 s l; published: 40 d, 0.2 s l.
#include <algorithm>
#include <cmath>

#include "process/compare/statistics.h"
#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kDiameter = 5e-4, kFraction = 0.3;  // m; solid
constexpr double kEnlargements[] = {1, 2, 4};
constexpr double kAllowedGain = 0.01, kGainTime = 0.1;  // of the first kinetic energy, in so many s l
constexpr double kLeftOut = 0.1;                        // of the run, before energy is looked at
constexpr double kSmallestScatter = 1e-4;               // of gains, below which they are rounding
constexpr double kDrawnUpTo = 1.25;                     // us, steps whose kinetic energy is drawn

struct Box {
  double width;     ///< d
  double duration;  ///< s, at l = 1
};

Box box_of(LabSize size) {
  if (size == LabSize::coarse) return {10, 0.05};
  return size == LabSize::medium ? Box{20, 0.1} : Box{40, 0.2};
}

/// us, at l = 1.
std::vector<double> steps(LabSize size) {
  std::vector<double> all;
  const double between = size == LabSize::coarse ? 0.2 : 0.1, first = size == LabSize::coarse ? 0.4 : 0.2;
  for (int k = 0; first + k * between < 2.05; ++k) all.push_back(std::round(10 * (first + k * between)) / 10);
  return all;
}

std::string name_of(double enlargement, double step) {
  return "l = " + plain(enlargement) + ", " + plain(step * enlargement) + " us";
}

/// All of an enlargement: a run that is missing says nothing about its step.
std::vector<std::string> runs_of(LabSize size, double l) {
  std::vector<std::string> runs;
  for (const double step : steps(size)) runs.push_back(name_of(l, step));
  return runs;
}

LabRun critical_step_run(const Box& box, double l, double step) {
  const double width = box.width * kDiameter * l, half = 0.5 * width, inside = half - 0.01 * kDiameter * l;
  LabRun run{name_of(l, step), "periodic_box.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", millimetres(kDiameter * l));
  set += line("pour.from", point_in_millimetres(-inside, -half, -half));
  set += line("pour.to", point_in_millimetres(inside, half, half));
  set += line("pour.fill_height", millimetres(width));
  set += line("pour.solid_fraction", plain(kFraction));
  set += line("tool.\"left wall\".position", point_in_millimetres(-half, 0, 0));
  set += line("tool.\"right wall\".position", point_in_millimetres(half, 0, 0));
  set += line("step.fly.duration", with_unit(box.duration * l, "s"));
  set += line("probe.energy.interval", with_unit(box.duration * l / 500, "s"));
  set += line("numerics.periodic", "{ y = " + millimetres(width) + ", z = " + millimetres(width) + " }");
  set += line("numerics.time_step", with_unit(step * l, "us"));
  return run;
}

enum class Energy { all, kinetic };

/// Kinetic and elastic energy, or the kinetic one alone, over the first kinetic energy, from the time on that
/// velocities are given.
TimeCurve energy_of(const SeedResults& seed, const std::string& run, Energy which) {
  const TimeCurve kinetic = probe_curve(seed, run, "energy", "kinetic"),
                  elastic = probe_curve(seed, run, "energy", "contacts");
  TimeCurve all;
  double first = 0;
  for (std::size_t k = 0; k < kinetic.time.size(); ++k) {
    if (first <= 0) first = kinetic.value[k] + elastic.value[k];
    if (first <= 0) continue;
    all.time.push_back(kinetic.time[k]);
    all.value.push_back((kinetic.value[k] + (which == Energy::all ? elastic.value[k] : 0)) / first);
  }
  return all;
}

/// Gain of energy in 0.1 s l over the first one.
double gain_of(const SeedResults& seed, double l, double step, Energy which = Energy::all) {
  const TimeCurve energy = energy_of(seed, name_of(l, step), which);
  if (energy.time.size() < 2) return kNone;
  const double from = energy.time.front() + kLeftOut * (energy.time.back() - energy.time.front());
  return slope_of(energy, from, energy.time.back()) * kGainTime * l;
}

/// us, the largest step up to which the gain stays within 1 %; NaN where no step does, or all do.
double critical_step(const SeedResults& seed, LabSize size, double l) {
  double largest = kNone;
  for (const double step : steps(size)) {
    const double gain = gain_of(seed, l, step);
    if (!std::isfinite(gain)) return kNone;
    if (std::abs(gain) >= kAllowedGain) return largest;
    largest = step * l;
  }
  return kNone;
}

/// The same for the kinetic energy alone, whose gain must also lie within twice the scatter of that of all
/// smaller steps, two of them at least (Hu 2024, section 4.4).
double critical_step_by_motion(const SeedResults& seed, LabSize size, double l) {
  double largest = kNone;
  std::vector<double> smaller;
  for (const double step : steps(size)) {
    const double gain = gain_of(seed, l, step, Energy::kinetic);
    if (!std::isfinite(gain)) return kNone;
    const Sample before = sample_of(smaller);
    const bool stands_out =
        smaller.size() > 1 && std::abs(gain - before.mean) > 2 * std::max(before.scatter, kSmallestScatter);
    if (std::abs(gain) >= kAllowedGain || stands_out) return largest;
    smaller.push_back(gain);
    largest = step * l;
  }
  return kNone;
}

/// Kinetic energy of the original spheres over time with some of the steps.
results::ExperimentChart kinetic_energy_chart(LabSize size, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "kinetic_energy";
  chart.title = "Kinetic energy of elastic spheres over time";
  chart.subtitle = "l = 1, by the time step; contacts hold the rest of the energy";
  chart.x = {.label = "Time [s]", .lower = 0};
  chart.y = {.label = "Kinetic energy over that at the start [1]"};
  for (const double step : steps(size)) {
    if (step > kDrawnUpTo || !seed.has(name_of(1, step))) continue;
    const TimeCurve energy = energy_of(seed, name_of(1, step), Energy::kinetic);
    if (energy.time.empty()) continue;
    results::ExperimentSeries series{.name = plain(step) + " us",
                                     .role = results::ExperimentSeries::Role::predicted,
                                     .x = {},
                                     .y = energy.value};
    for (const double time : energy.time) series.x.push_back(time - energy.time.front());
    chart.series.push_back(series);
  }
  return chart;
}

results::ExperimentChart critical_step_chart(LabSize size, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "critical_step";
  chart.title = "Energy gain over the time step";
  chart.subtitle =
      "Elastic spheres in a box (Hu 2024, section 4.4); published: the same for all l over step / l";
  chart.x = {.label = "Time step / l [us]"};
  chart.y = {.label = "Energy gain in 0.1 s l [%]"};
  for (const double l : kEnlargements) {
    results::ExperimentSeries series{.name = "l = " + plain(l), .x = {}, .y = {}};
    for (const double step : steps(size)) {
      if (!seed.has(name_of(l, step))) continue;
      const double gain = gain_of(seed, l, step);
      if (!std::isfinite(gain)) continue;
      series.x.push_back(step);
      series.y.push_back(100 * gain);
    }
    if (!series.x.empty()) chart.series.push_back(series);
  }
  return chart;
}

}  // namespace

LabPlan plan_critical_step(const LabSetting& setting) {
  const LabSize size = setting.size;
  const Box box = box_of(size);
  LabPlan plan;
  for (const double l : kEnlargements)
    for (const double step : steps(size)) plan.runs.push_back(critical_step_run(box, l, step));
  auto both = runs_of(size, 1);
  for (const auto& run : runs_of(size, 4)) both.push_back(run);
  plan.quantities.push_back({.id = "BOX-theory",
                             .quantity = "",
                             .unit = "",
                             .runs = both,
                             .value = [size](const SeedResults& seed) {
                               return critical_step(seed, size, 4) / (4 * critical_step(seed, size, 1));
                             }});
  for (const double l : kEnlargements)
    plan.quantities.push_back(
        {.id = "critical step, l = " + plain(l),
         .quantity = "largest step with a gain below 1 %, l = " + plain(l),
         .unit = "us",
         .runs = runs_of(size, l),
         .value = [size, l](const SeedResults& seed) { return critical_step(seed, size, l); }});
  for (const double l : kEnlargements)
    plan.quantities.push_back(
        {.id = "critical step by kinetic energy, l = " + plain(l),
         .quantity = "largest step with a gain of kinetic energy below 1 %, l = " + plain(l),
         .unit = "us",
         .runs = runs_of(size, l),
         .value = [size, l](const SeedResults& seed) { return critical_step_by_motion(seed, size, l); }});
  plan.charts = [size](const SeedResults& seed) {
    return std::vector{critical_step_chart(size, seed), kinetic_energy_chart(size, seed)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
