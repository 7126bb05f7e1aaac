#include "process/laboratory/flow/hopper_charts.h"

#include <algorithm>
#include <cmath>

#include "process/results/formatted.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentChart;
using results::ExperimentSeries;

int row_at(const continuum::HopperGrid& grid, double z) {
  return std::clamp(static_cast<int>(std::lround(z / grid.spacing_z())), 0, grid.rows);
}

/// One velocity of the fields along a row; x and speeds over what they are measured in.
ExperimentSeries measured_row(const std::string& name, const HopperFields& fields,
                              const std::vector<double>& field, double z, double length, double speed) {
  ExperimentSeries series{.name = name, .x = {}, .y = {}};
  const int row = row_at(fields.grid, z);
  for (int c = 0; c < fields.grid.columns; ++c) {
    series.x.push_back(fields.grid.x(c) / length);
    series.y.push_back(fields.at(field, c, row) / speed);
  }
  return series;
}

/// One velocity of a model along a row, m to mm.
ExperimentSeries predicted_row(const std::string& name, const continuum::HopperFlow& flow, bool upright,
                               double z) {
  ExperimentSeries series{.name = name, .role = ExperimentSeries::Role::predicted, .x = {}, .y = {}};
  const int row = row_at(flow.grid, z);
  for (int c = 0; c < flow.grid.columns; ++c) {
    const double lateral = 0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row));
    series.x.push_back(1e3 * flow.grid.x(c));
    series.y.push_back(upright ? flow.vertical_at(c, row) : lateral);
  }
  return series;
}

constexpr std::size_t kMaxPoints = 400;
constexpr double kMinSpeed = 0.02;                           // of sqrt(gD)
constexpr double kHeights[] = {0.25, 0.5, 0.75, 1, 1.5, 2};  // over the slit's width

/// Evenly chosen points, at most about kMaxPoints, m to mm.
ExperimentSeries some_nodes(const std::vector<continuum::LengthPoint>& points) {
  ExperimentSeries nodes{
      .name = "nodes of the grid", .role = ExperimentSeries::Role::points, .x = {}, .y = {}};
  const std::size_t every = 1 + points.size() / kMaxPoints;
  for (std::size_t k = 0; k < points.size(); k += every) {
    nodes.x.push_back(points[k].fraction);
    nodes.y.push_back(1e3 * points[k].length);
  }
  return nodes;
}

/// Diffusion length over the solid fractions between two, m to mm.
ExperimentSeries length_curve(const std::string& name, const continuum::LengthOfFraction& length, double from,
                              double to) {
  ExperimentSeries series{.name = name, .role = ExperimentSeries::Role::predicted, .x = {}, .y = {}};
  for (int k = 0; k <= 60; ++k) {
    const double fraction = from + (to - from) * k / 60;
    series.x.push_back(fraction);
    series.y.push_back(1e3 * length(fraction));
  }
  return series;
}

}  // namespace

ExperimentChart length_chart(const std::vector<continuum::LengthPoint>& points,
                             const continuum::LengthOfFraction& fitted) {
  ExperimentChart chart;
  chart.name = "hopper_diffusion_length";
  chart.title = "Local diffusion length over the solid fraction";
  chart.subtitle = "B = -v_x / (dv_z/dx) where |v_x| > 0.1 sqrt(gD), set-up 1";
  chart.note = results::formatted(
      "Fit of Eq. 5.5 below the peak: B_0 = %.3g mm, n_div = %.3f; published: 0.116 mm, 0.353",
      1e3 * fitted.smallest, fitted.diverging);
  chart.x = {.label = "Solid fraction"};
  chart.y = {.label = "B [mm]", .logarithmic = true};
  constexpr int kClasses = 16;
  ExperimentSeries mean{.name = "mean", .x = {}, .y = {}}, low = mean, high = mean;
  low.name = "mean less deviation";
  high.name = "mean and deviation";
  double from = 1, to = 0;
  for (const auto& one : in_classes(points, kClasses)) {
    mean.x.push_back(one.fraction);
    mean.y.push_back(1e3 * one.mean);
    low.x.push_back(one.fraction);
    low.y.push_back(1e3 * std::max(0.05 * one.mean, one.mean - one.deviation));
    high.x.push_back(one.fraction);
    high.y.push_back(1e3 * (one.mean + one.deviation));
    from = std::min(from, one.fraction);
    to = std::max(to, one.fraction);
  }
  chart.series = {some_nodes(points), mean, low, high};
  if (to > from) {
    chart.series.push_back(length_curve("Eq. 5.6, fitted", fitted, from, to));
    chart.series.push_back(length_curve("Eq. 5.6, published", continuum::LengthOfFraction{}, from, to));
  }
  return chart;
}

ExperimentChart length_field_chart(const HopperSetup& setup, const HopperFields& fields) {
  ExperimentChart chart;
  const double width = setup.equivalent_slit, least = kMinSpeed * std::sqrt(setup.gravity * width);
  chart.name = "hopper_length_field";
  chart.title = "Local diffusion length over x at six heights";
  chart.subtitle = results::formatted(
      "B = -v_x / (dv_z/dx) where |v_x| > 0.02 sqrt(gD), set-up 1, D = %.4g mm", 1e3 * width);
  chart.note = "Kinematic model: 1.8 mm everywhere";
  chart.x = {.label = "x [mm]"};
  chart.y = {.label = "B [mm]", .logarithmic = true, .lower = 0.1, .upper = 100};
  for (const double height : kHeights) {
    ExperimentSeries series{.name = results::formatted("z = %.2f D", height), .x = {}, .y = {}};
    const int row = row_at(fields.grid, height * width);
    for (int c = 1; c + 1 < fields.grid.columns; ++c) {
      const double length = local_length(fields, c, row);
      const bool flows = std::abs(fields.at(fields.horizontal, c, row)) > least;
      series.x.push_back(1e3 * fields.grid.x(c));
      series.y.push_back(flows && length > 0 ? 1e3 * length : std::nan(""));
    }
    chart.series.push_back(series);
  }
  return chart;
}

void add_profile_charts(const HopperFields& fields, double width, const HopperModels& models,
                        std::vector<ExperimentChart>& charts) {
  for (const bool upright : {true, false})
    for (const double height : kHeights) {
      const double z = height * width;
      if (z > fields.grid.height) continue;
      ExperimentChart chart;
      chart.name = results::formatted("hopper_v%s_%.2f", upright ? "z" : "x", height);
      chart.title = results::formatted("%s velocity %.3g mm above the slit",
                                       upright ? "Vertical" : "Horizontal", 1e3 * z);
      chart.subtitle = results::formatted("set-up 1, %.2f D, D = %.4g mm", height, 1e3 * width);
      chart.note = "KM: B = 1.8 mm. CKM: B of the solid fraction as fitted, fractions of the DEM.";
      chart.x = {.label = "x [mm]"};
      chart.y = {.label = upright ? "v_z [m/s]" : "v_x [m/s]"};
      chart.series = {measured_row("DEM", fields, upright ? fields.vertical : fields.horizontal, z, 1e-3, 1),
                      predicted_row("kinematic model", *models.incompressible, upright, z),
                      predicted_row("compressible kinematic model", *models.compressible, upright, z)};
      charts.push_back(chart);
    }
}

void add_scaling_charts(const std::vector<HopperSetup>& setups, const std::vector<HopperFields>& fields,
                        const std::vector<double>& widths, const std::vector<double>& scales,
                        std::vector<ExperimentChart>& charts) {
  for (const bool upright : {true, false})
    for (const double height : {0.25, 0.5, 1.0}) {
      ExperimentChart chart;
      chart.name = results::formatted("hopper_scaling_v%s_%.2f", upright ? "z" : "x", height);
      chart.title = results::formatted("%s velocity over sqrt(gD) at z = %.2f D",
                                       upright ? "Vertical" : "Horizontal", height);
      chart.subtitle = "five set-ups (Bierwisch 2009, Table 5.1)";
      chart.note = "D: width of the source's slit, as wide for its grains as the slit here for these";
      chart.x = {.label = "x / D", .lower = -2, .upper = 2};
      chart.y = {.label = upright ? "v_z / sqrt(gD)" : "v_x / sqrt(gD)"};
      for (std::size_t k = 0; k < setups.size(); ++k)
        chart.series.push_back(measured_row(setups[k].name, fields[k],
                                            upright ? fields[k].vertical : fields[k].horizontal,
                                            height * widths[k], widths[k], scales[k]));
      charts.push_back(chart);
    }
}

}  // namespace diefill::process::laboratory
