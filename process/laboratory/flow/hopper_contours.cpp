#include "process/laboratory/flow/hopper_contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "process/input/units.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentChart;
using results::ExperimentSeries;

constexpr std::array kVertical = {-0.4, -0.3, -0.2, -0.1, -0.05};            // m/s
constexpr std::array kHorizontal = {-0.06, -0.04, -0.02, 0.02, 0.04, 0.06};  // m/s
constexpr std::array kFractions = {0.20, 0.25, 0.30, 0.34};

/// The way from a node to the next one in x or, `upright`, in z. A line of equal value crosses it once.
struct Edge {
  int column = 0, row = 0;
  bool upright = false;
  auto operator<=>(const Edge&) const = default;
};
using Neighbours = std::map<Edge, std::vector<Edge>>;

/// Nodes of a field and the level of the lines to find.
struct Sought {
  const continuum::HopperGrid& grid;
  const std::vector<double>& field;
  double level;

  double at(int column, int row) const {
    return field[static_cast<std::size_t>(row) * grid.columns + column];
  }
  double end_of(const Edge& edge) const { return at(edge.column + !edge.upright, edge.row + edge.upright); }
  bool crosses(const Edge& edge) const {
    return (at(edge.column, edge.row) > level) != (end_of(edge) > level);
  }
  /// m
  Eigen::Vector2d point_on(const Edge& edge) const {
    const double here = at(edge.column, edge.row), share = (level - here) / (end_of(edge) - here);
    return {grid.x(edge.column) + (edge.upright ? 0 : share * grid.spacing_x()),
            (edge.row + (edge.upright ? share : 0)) * grid.spacing_z()};
  }
};

/// Joins the edges of the cell above and right of a node that the lines go through from one to the other.
void join_across_cell(const Sought& sought, int column, int row, Neighbours& neighbours) {
  for (int k = 0; k < 4; ++k)
    if (!std::isfinite(sought.at(column + k % 2, row + k / 2))) return;
  std::vector<Edge> crossed;
  for (const Edge& edge : {Edge{column, row, false}, Edge{column + 1, row, true},
                           Edge{column, row + 1, false}, Edge{column, row, true}})
    if (sought.crosses(edge)) crossed.push_back(edge);
  for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
    neighbours[crossed[k]].push_back(crossed[k + 1]);
    neighbours[crossed[k + 1]].push_back(crossed[k]);
  }
}

/// Removes the line that continues from `at` from `neighbours`.
std::vector<Edge> taken_from(Edge at, Neighbours& neighbours) {
  std::vector<Edge> line = {at};
  for (auto place = neighbours.find(at); !place->second.empty(); place = neighbours.find(at)) {
    const Edge next = place->second.back();
    place->second.pop_back();
    std::erase(neighbours[next], at);
    line.push_back(at = next);
  }
  std::erase_if(neighbours, [](const auto& one) { return one.second.empty(); });
  return line;
}

ExperimentSeries empty_series(const std::string& name, ExperimentSeries::Role role) {
  return {.name = name, .role = role, .x = {}, .y = {}};
}

/// The lines of the DEM as points, some way apart.
template <class Levels>
ExperimentSeries as_points(const std::string& name, const continuum::HopperGrid& grid,
                           const std::vector<double>& field, const Levels& levels) {
  constexpr std::size_t kEvery = 3;
  auto series = empty_series(name, ExperimentSeries::Role::points);
  for (const double level : levels)
    for (const auto& line : contour_lines(grid, field, level))
      for (std::size_t k = 0; k < line.size(); k += kEvery) {
        series.x.push_back(1e3 * line[k].x());
        series.y.push_back(1e3 * line[k].y());
      }
  return series;
}

/// The lines of a model, NaN between them.
template <class Levels>
ExperimentSeries as_lines(const std::string& name, const continuum::HopperGrid& grid,
                          const std::vector<double>& field, const Levels& levels) {
  auto series = empty_series(name, ExperimentSeries::Role::predicted);
  for (const double level : levels)
    for (const auto& line : contour_lines(grid, field, level)) {
      for (const auto& point : line) {
        series.x.push_back(1e3 * point.x());
        series.y.push_back(1e3 * point.y());
      }
      series.x.push_back(std::numeric_limits<double>::quiet_NaN());
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  return series;
}

/// A model's velocities in the middle of columns.
std::vector<double> velocities_of(const continuum::HopperFlow& flow, bool upright) {
  if (upright) return flow.vertical;
  std::vector<double> middle;
  for (int row = 0; row <= flow.grid.rows; ++row)
    for (int c = 0; c < flow.grid.columns; ++c)
      middle.push_back(0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row)));
  return middle;
}

ExperimentChart chart_over_hopper(const std::string& name, const std::string& title,
                                  const continuum::HopperGrid& grid) {
  ExperimentChart chart;
  chart.name = name;
  chart.title = title;
  chart.subtitle = "set-up 1, means over time above the slit, which lies at z = 0";
  chart.x = {.label = "x [mm]", .lower = -500 * grid.width, .upper = 500 * grid.width};
  chart.y = {.label = "z [mm]", .lower = 0, .upper = 1e3 * grid.height};
  return chart;
}

template <class Levels>
ExperimentChart velocity_contours(const HopperFields& fields, const HopperModels& models, bool upright,
                                  const Levels& levels) {
  auto chart = chart_over_hopper(
      upright ? "hopper_contours_vz" : "hopper_contours_vx",
      upright ? "Lines of equal vertical velocity" : "Lines of equal horizontal velocity", fields.grid);
  chart.note = "Lines at";
  for (const double level : levels) chart.note += ' ' + number_text(level);
  chart.note += " m/s. KM: B = 1.8 mm. CKM: B of the solid fraction as fitted, fractions of the DEM.";
  chart.series = {as_points("DEM", fields.grid, upright ? fields.vertical : fields.horizontal, levels),
                  as_lines("kinematic model", models.incompressible->grid,
                           velocities_of(*models.incompressible, upright), levels),
                  as_lines("compressible kinematic model", models.compressible->grid,
                           velocities_of(*models.compressible, upright), levels)};
  return chart;
}

ExperimentChart fraction_contours(const HopperFields& fields) {
  auto chart = chart_over_hopper("hopper_contours_fraction", "Lines of equal solid fraction", fields.grid);
  chart.note = "DEM; the compressible kinematic model takes these fractions";
  for (const double level : kFractions)
    chart.series.push_back(as_points(number_text(level), fields.grid, fields.fraction, std::array{level}));
  return chart;
}

}  // namespace

std::vector<std::vector<Eigen::Vector2d>> contour_lines(const continuum::HopperGrid& grid,
                                                        const std::vector<double>& field, double level) {
  const Sought sought{grid, field, level};
  Neighbours neighbours;
  for (int row = 0; row < grid.rows; ++row)
    for (int c = 0; c + 1 < grid.columns; ++c) join_across_cell(sought, c, row, neighbours);
  std::vector<std::vector<Eigen::Vector2d>> lines;
  while (!neighbours.empty()) {
    // Open lines from an end on, so that each is taken whole; then those that are closed.
    auto start = std::find_if(neighbours.begin(), neighbours.end(),
                              [](const auto& one) { return one.second.size() == 1; });
    if (start == neighbours.end()) start = neighbours.begin();
    auto& line = lines.emplace_back();
    for (const Edge& edge : taken_from(Edge(start->first), neighbours)) line.push_back(sought.point_on(edge));
  }
  return lines;
}

void add_contour_charts(const HopperFields& fields, const HopperModels& models,
                        std::vector<ExperimentChart>& charts) {
  charts.push_back(velocity_contours(fields, models, true, kVertical));
  charts.push_back(velocity_contours(fields, models, false, kHorizontal));
  charts.push_back(fraction_contours(fields));
}

}  // namespace diefill::process::laboratory
