// Which time steps, densities and shear rates keep the temperature of a fluid of particles.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/numerics/out_of_range.h"
#include "process/laboratory/published/sawing/viscosity.h"
#include "process/laboratory/stability/registry.h"
#include "process/measure/figures/line_fit.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using sawing::ShearedSlurry;

constexpr double kTolerated = 0.05;  // error of the temperature

/// |T - 1|, infinite where the run breaks down, or the box is too small for what moves in a step.
double temperature_error(ShearedSlurry fluid, const ExperimentOptions& options) {
  const double time =
      options.quick ? 100 : 200;  // reduced, of the samples: shorter runs may not break down yet
  fluid.edge = options.quick ? 5 : 10;
  fluid.settling = static_cast<int>(10 / fluid.time_step);
  fluid.sampled = static_cast<int>(time / fluid.time_step);
  try {
    constexpr double kBroken = 1;  // above this error the fluid has broken down
    const double error = std::abs(measure(fluid, 1).temperature - 1);
    return error < kBroken ? error : std::numeric_limits<double>::infinity();
  } catch (const engine::OutOfRange&) {
    return std::numeric_limits<double>::infinity();
  } catch (const std::invalid_argument&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// Errors over one quantity of the fluid, and the first values at which more than kTolerated is reached and
/// no run is possible; NaN: not at the values tried.
struct Search {
  ExperimentSeries series;
  double limit = std::numeric_limits<double>::quiet_NaN();
  double fails = std::numeric_limits<double>::quiet_NaN();
};

/// `nth` of the three searches.
Search search(const std::vector<double>& values, double ShearedSlurry::*quantity, int nth,
              const ExperimentOptions& options) {
  Search found;
  found.series.name = "measured";
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    options.on_progress((nth + static_cast<double>(k) / static_cast<double>(values.size())) / 3, "fluid");
    ShearedSlurry fluid{.rate = 0};
    fluid.*quantity = value;
    const double error = temperature_error(fluid, options);
    if (std::isfinite(error)) found.series.x.push_back(value), found.series.y.push_back(error);
    if (error > kTolerated && std::isnan(found.limit)) found.limit = value;
    if (std::isfinite(error)) continue;
    found.fails = value;
    break;
  }
  return found;
}

/// Slope of the logarithm of the error over that of the step, from the usual step on: below it the error is
/// no more than a few times its scatter.
double order_of(const ExperimentSeries& series) {
  constexpr double kUsual = 0.01;
  std::vector<double> step, error;
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (series.x[k] < kUsual) continue;
    step.push_back(std::log(series.x[k]));
    error.push_back(std::log(series.y[k]));
  }
  return fit_line(step, error).slope;
}

void add_limits(const std::string& quantity, const Search& found, results::ExperimentResult& result) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!std::isnan(found.limit))
    result.limits.push_back({"fluid: " + quantity + " with more than 5 % error of the temperature",
                             found.limit, kNone, "reduced", ""});
  if (!std::isnan(found.fails))
    result.limits.push_back(
        {"fluid: " + quantity + " at which no run is possible", found.fails, kNone, "reduced", ""});
}

results::ExperimentChart chart_of(const std::string& name, const std::string& label,
                                  const ExperimentSeries& series) {
  results::ExperimentChart chart;
  chart.name = "fluid_" + name;
  chart.title = "Error of the temperature of a DPD fluid";
  chart.subtitle = "Reduced units; otherwise density 4.15, time step 0.01, no shear";
  chart.x = {.label = label, .logarithmic = true};
  chart.y = {.label = "|T - 1| [1]", .logarithmic = true};
  chart.series = {series};
  return chart;
}

}  // namespace

void find_fluid_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const Search step = search({0.005, 0.01, 0.015, 0.02, 0.025, 0.03}, &ShearedSlurry::time_step, 0, options);
  const Search density = search({2, 3, 4.15, 5, 6, 7, 8, 10}, &ShearedSlurry::density, 1, options);
  const Search rate = search({0.1, 0.2, 0.5, 1, 2, 5, 10}, &ShearedSlurry::rate, 2, options);
  add_limits("step", step, result);
  // Velocities are predicted over the whole step (OP-3): lambda = 1 of Groot and Warren
  // 1997. For a particle with friction gamma and noise, the stationary temperature is then off by
  // gamma (1/2 - lambda) times the step: first order but for lambda = 1/2.
  result.limits.push_back({"fluid: order of the temperature's error in the step", order_of(step.series), 1,
                           "1", "velocities predicted over a whole step (OP-3)"});
  add_limits("density", density, result);
  add_limits("shear rate", rate, result);
  result.charts = {chart_of("step", "Time step, reduced [1]", step.series),
                   chart_of("density", "Density, reduced [1]", density.series),
                   chart_of("rate", "Shear rate, reduced [1]", rate.series)};
}

}  // namespace diefill::process::laboratory
