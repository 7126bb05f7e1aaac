// Chart of cost against error, from a formula to fine grains, of the tables in process/estimate and
// process/plan: ninja cost_chart && bin/cost_chart process/estimate/against_runs.csv
// process/plan/grain_size_errors.csv FOLDER
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "process/continuum/discharge.h"
#include "render/charts/chart.h"
#include "render/offscreen/start_offscreen.h"

namespace {

using Row = std::map<std::string, std::string>;

/// The rows of a CSV file by their heading. Throws std::runtime_error where it cannot be read.
std::vector<Row> rows_of(const std::string& file) {
  std::ifstream text(file);
  if (!text) throw std::runtime_error(file + ": cannot be read");
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(text, line);
  const auto heading = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(text, line)) {
    const auto cells = cells_of(line);
    Row row;
    for (std::size_t k = 0; k < heading.size() && k < cells.size(); ++k) row[heading[k]] = cells[k];
    rows.push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& name) {
  return std::stod(row.at(name));
}

/// s that one evaluation of Eq. 5.17 (Bierwisch 2009) takes.
double seconds_of_a_formula() {
  constexpr int kTimes = 200000;
  const auto began = std::chrono::steady_clock::now();
  volatile double sum = 0;
  for (int k = 0; k < kTimes; ++k)
    sum = sum + diefill::process::continuum::mass_of_passage(diefill::process::continuum::kSimulatedDischarge,
                                                             {3000, 6e-3, 0.01}, 0.032, 0.1 + 1e-7 * k);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / kTimes;
}

using diefill::render::Curve;
using diefill::render::CurveStyle;

Curve points(const std::string& name) {
  Curve curve;
  curve.name = name;
  curve.style = CurveStyle::kMarkers;
  return curve;
}

constexpr double kLeast = 1e-3;  // below it, errors are drawn there

void add(Curve& curve, double seconds, double error) {
  curve.x.push_back(seconds);
  curve.y.push_back(100 * std::max(kLeast, error));
}

/// Formula without a floor, and the whole estimate, against the same runs.
void add_estimates(const std::vector<Row>& rows, std::vector<Curve>& curves) {
  Curve formula = points("Eq. 5.17 alone, inflow as if there were no floor"),
        whole = points("diefill estimate");
  const double seconds = seconds_of_a_formula();
  for (const Row& row : rows) {
    const double dem = number(row, "dem");
    add(formula, seconds, std::abs(std::min(1.0, number(row, "offered")) / dem - 1));
    add(whole, number(row, "estimate_s"), std::abs(number(row, "estimate") / dem - 1));
  }
  curves.push_back(formula);
  curves.push_back(whole);
}

/// The runs of one cavity and powder.
using Series = std::vector<const Row*>;

/// What the figure would be with grains of no size: limit of a line over d/b.
double limit_of(const Series& series) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto count = static_cast<double>(series.size());
  for (const Row* row : series) {
    x += number(*row, "share") / count;
    y += number(*row, "filled") / count;
  }
  for (const Row* row : series) {
    xx += std::pow(number(*row, "share") - x, 2);
    xy += (number(*row, "share") - x) * (number(*row, "filled") - y);
  }
  return y - xy / xx * x;
}

/// Single runs with grains of each size.
void add_runs(const std::vector<Row>& rows, std::vector<Curve>& curves) {
  std::map<std::string, Series> all;
  for (const Row& row : rows) all[row.at("scene") + row.at("powder")].push_back(&row);
  std::map<double, Curve> by_share;
  for (const auto& [name, series] : all)
    for (const Row* row : series) {
      const double share = number(*row, "share");
      char title[80];
      std::snprintf(title, sizeof title, "simulation of small dies, d/b = %.2f", share);
      auto& curve = by_share.try_emplace(-share, points(title)).first->second;
      add(curve, number(*row, "seconds"), std::abs(number(*row, "filled") / limit_of(series) - 1));
    }
  for (const auto& [share, curve] : by_share) curves.push_back(curve);
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fprintf(stderr, "cost_chart: expected AGAINST_RUNS.csv GRAIN_SIZE_ERRORS.csv FOLDER\n");
    return 2;
  }
  diefill::render::start_offscreen(count, words);
  diefill::render::Chart chart;
  chart.title = "Cost against error of the mass in the cavity";
  chart.subtitle =
      "one point a case; estimates against runs of the same grains, runs against grains of no size";
  chart.note =
      "Errors below 0.1 % are drawn there. The narrow ring with grains of 0.47 mm took 4,500 CPU hours in "
      "2009 "
      "(1.6e7 s; Bierwisch 2009, chapter 7).";
  chart.x.label = "Processor time [s]";
  chart.x.logarithmic = true;
  chart.x.upper = 1e8;
  chart.y.label = "Error [%]";
  chart.y.logarithmic = true;
  add_estimates(rows_of(words[1]), chart.curves);
  add_runs(rows_of(words[2]), chart.curves);
  Curve finest = points("narrow ring, d = 0.47 mm, 2009 (error: none to be held against)");
  add(finest, 4500.0 * 3600, kLeast);
  chart.curves.push_back(finest);
  diefill::render::draw_chart(std::string(words[3]) + "/cost_against_error.png", chart);
  return 0;
}
