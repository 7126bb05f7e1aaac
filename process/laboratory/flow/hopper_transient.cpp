// Discharge from the opening of the slit on (Bierwisch 2009, section 5.2.1): powder that has run out of
// hoppers with slits of two widths over time, Eq. 5.15 fitted to all of them together, and the steady rate.
#include "process/laboratory/flow/hopper_transient.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/laboratory/flow/hopper_setups.h"
#include "process/laboratory/flow/registry.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kFlowTime = 0.3;           // s after the opening
constexpr double kSourceDepth = 2.16e-3;    // m, b of the source's hopper
constexpr double kSourceFraction = 0.365;   // its bulk solid fraction
constexpr double kSourceGrain = 1.413e-11;  // m^3, its grains (Table C.4)

/// A slit of `millimetres` in a hopper of this width; the level falls for kFlowTime, by half before the
/// steady rate is taken.
HopperSetup slit_of(double millimetres, double width, double fill, double factor) {
  HopperSetup setup = source_hopper(factor);
  char name[40];
  std::snprintf(name, sizeof name, "D %.3g mm", millimetres);
  setup.name = name;
  setup.equivalent_slit = 1e-3 * millimetres;
  setup.width = width;
  setup.fill = fill;
  const double fall =
      kFlowTime * continuum::kSimulatedDischarge.steady * setup.equivalent_slit * speed_scale(setup) / width;
  setup.from = fill - 0.5 * fall;
  setup.to = fill - fall;
  fit_to_grains(factor, setup);
  return setup;
}

/// Areas of bulk powder over the period, m^2, as masses at unit length and density. Errors in proportion to
/// D^2, so that all slits count alike.
continuum::DischargeData data_of(const std::vector<HopperSetup>& setups,
                                 const std::vector<HopperFields>& fields) {
  constexpr double kError = 0.01;
  continuum::DischargeData data;
  data.density = 1;
  for (std::size_t k = 0; k < setups.size(); ++k) {
    const double width = setups[k].equivalent_slit;
    for (std::size_t n = 0; n < fields[k].time.size(); ++n)
      data.points.push_back({.value = fields[k].discharged[n],
                             .error = kError * width * width,
                             .time = fields[k].time[n],
                             .width = width,
                             .length = 1});
  }
  return data;
}

results::ExperimentSeries measured_series(const HopperSetup& setup, const HopperFields& fields) {
  results::ExperimentSeries series{.name = setup.name, .x = {}, .y = {}};
  constexpr std::size_t kPoints = 40;
  const double width = setup.equivalent_slit, unit = std::sqrt(width / setup.gravity);
  const std::size_t every = 1 + fields.time.size() / kPoints;
  for (std::size_t n = 0; n < fields.time.size(); n += every) {
    series.x.push_back(fields.time[n] / unit);
    series.y.push_back(fields.discharged[n] / (width * width));
  }
  return series;
}

/// Eq. 5.15 integrated, over t sqrt(g/D).
results::ExperimentSeries law_series(const std::string& name, const continuum::TransientCoefficients& numbers,
                                     double longest) {
  constexpr int kPoints = 100;
  results::ExperimentSeries series{
      .name = name, .role = results::ExperimentSeries::Role::predicted, .x = {}, .y = {}};
  for (int k = 0; k <= kPoints; ++k) {
    const double x = continuum::kBurst + (longest - continuum::kBurst) * k / kPoints;
    series.x.push_back(x);
    series.y.push_back(continuum::discharged_share(numbers, x - continuum::kBurst));
  }
  return series;
}

results::ExperimentChart chart_of(const std::vector<HopperSetup>& setups,
                                  const std::vector<HopperFields>& fields,
                                  const continuum::DischargeFit& fit) {
  results::ExperimentChart chart;
  chart.name = "hopper_transient";
  chart.title = "Discharged mass since the slit opened";
  chart.subtitle = "Hopper, model D, friction 0.5, no cohesion (Bierwisch 2009, section 5.2.1)";
  chart.x = {.label = "t sqrt(g/D)", .lower = 0};
  chart.y = {.label = "Mass over rho b D^2", .lower = 0};
  double longest = 0;
  for (std::size_t k = 0; k < setups.size(); ++k) {
    chart.series.push_back(measured_series(setups[k], fields[k]));
    longest = std::max(longest, chart.series.back().x.back());
  }
  const continuum::TransientCoefficients found = {fit.number("C_B"), fit.number("C_I"), fit.number("C_F"),
                                                  fit.number("beta")};
  chart.series.push_back(law_series("Eq. 5.15, fitted", found, longest));
  chart.series.push_back(law_series("Eq. 5.15, published", continuum::kSimulatedDischarge, longest));
  return chart;
}

}  // namespace

std::vector<HopperSetup> transient_setups(double factor) {
  return {slit_of(10, 32e-3, 60e-3, factor), slit_of(15, 45e-3, 75e-3, factor)};
}

continuum::DischargeFit fit_transient(const std::vector<HopperSetup>& setups,
                                      const std::vector<HopperFields>& fields) {
  return continuum::fit_discharge(continuum::DischargeLaw::transient, data_of(setups, fields));
}

std::vector<results::ExperimentFigure> transient_figures(const continuum::DischargeFit& fit,
                                                         const std::vector<HopperSetup>& setups,
                                                         const std::vector<HopperFields>& fields) {
  const bool open = fit.fit.shape_at_bound;
  const std::string how =
      open ? "the flow does not determine beta" : "Eq. 5.15 fitted to slits of 10 and 15 mm together";
  const auto number = [&](const char* name) { return open ? kNone : fit.number(name); };
  std::vector<results::ExperimentFigure> figures = {{"E01", number("C_B"), how},
                                                    {"E02", number("C_I"), how},
                                                    {"E03", number("C_F"), how},
                                                    {"E04", number("beta"), how}};
  figures.push_back({"E05", fields[0].outflow * kSourceDepth * kSourceFraction / kSourceGrain,
                     "slit of 10 mm, in grains of the source"});
  for (auto& figure : figures) figure.grain_diameter = setups[0].powder.grain_diameter;
  return figures;
}

void measure_transient(const ExperimentOptions& options, results::ExperimentResult& result) {
  const auto all = transient_setups(options.quick ? 5 : 4);
  const auto fields = run_packings(options, all, options.quick ? 1 : 3);
  const auto fit = fit_transient(all, fields);
  result.figures = transient_figures(fit, all, fields);
  for (std::size_t k = 0; k < all.size(); ++k)
    result.limits.push_back({"steady rate over D sqrt(gD), " + all[k].name,
                             fields[k].outflow / (all[k].equivalent_slit * speed_scale(all[k])),
                             continuum::kSimulatedDischarge.steady, "1", "Bierwisch 2009, Table 5.2"});
  result.charts.push_back(chart_of(all, fields, fit));
}

}  // namespace diefill::process::laboratory
