// Chart and table of cost against error, from a formula to the finest fill: ninja cost_chart &&
// bin/cost_chart process/estimate/against_runs.csv process/plan/grain_size_errors.csv
// process/estimate/ring_sizes.csv process/estimate
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "process/continuum/discharge.h"
#include "process/laboratory/published/csv_fields.h"
#include "render/charts/chart.h"
#include "render/offscreen/start_offscreen.h"

namespace {

using Row = std::map<std::string, std::string>;

/// The rows of a CSV file by their heading. Throws std::runtime_error where it cannot be read.
std::vector<Row> rows_of(const std::string& file) {
  std::ifstream text(file);
  if (!text) throw std::runtime_error(file + ": cannot be read");
  std::string line;
  std::getline(text, line);
  const auto heading = diefill::process::laboratory::csv_fields(line);
  std::vector<Row> rows;
  while (std::getline(text, line)) {
    const auto cells = diefill::process::laboratory::csv_fields(line);
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

/// Cases of one way to the mass in the cavity: processor time in s, and error.
struct Way {
  std::string name;
  std::string series;  ///< ways of one series differ in the size of the grains alone; a line joins them
  std::vector<double> seconds, errors;
  void add(double time, double error) {
    seconds.push_back(time);
    errors.push_back(std::abs(error));
  }
};

/// The value that `share` of the values do not exceed.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
}

/// Formula without a floor, and the whole estimate, against the same runs.
void add_estimates(const std::vector<Row>& rows, std::vector<Way>& ways) {
  Way formula{"Eq. 5.17 alone, as if there were no floor", "formula", {}, {}},
      whole{"diefill estimate", "estimate", {}, {}};
  const double seconds = seconds_of_a_formula();
  for (const Row& row : rows) {
    const double dem = number(row, "dem");
    formula.add(seconds, std::min(1.0, number(row, "offered")) / dem - 1);
    whole.add(number(row, "estimate_s"), number(row, "estimate") / dem - 1);
  }
  ways.push_back(formula);
  ways.push_back(whole);
}

/// What the figure would be with grains of no size: limit of a line over d/b.
double limit_of(const std::vector<const Row*>& series) {
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

/// Single runs with grains of each size, coarse ones first.
void add_runs(const std::vector<Row>& rows, std::vector<Way>& ways) {
  std::map<std::string, std::vector<const Row*>> all;
  for (const Row& row : rows) all[row.at("scene") + row.at("powder") + row.at("walls")].push_back(&row);
  std::map<double, Way> by_share;
  for (const auto& [name, series] : all)
    for (const Row* row : series) {
      const double share = number(*row, "share");
      char title[80];
      std::snprintf(title, sizeof title, "small dies, d/b = %.3g", share);
      by_share.try_emplace(-share, Way{title, "small dies", {}, {}})
          .first->second.add(number(*row, "seconds"), number(*row, "filled") / limit_of(series) - 1);
    }
  for (const auto& [share, way] : by_share) ways.push_back(way);
}

/// Fills of the narrow ring with coarser grains against the finest one, the last. Returns s of that.
double add_ring(const std::vector<Row>& rows, std::vector<Way>& ways) {
  const double finest = number(rows.back(), "filled");
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    char title[80];
    std::snprintf(title, sizeof title, "narrow ring, d/b = %.3g", number(rows[k], "share"));
    ways.push_back({title, "narrow ring", {}, {}});
    ways.back().add(number(rows[k], "seconds"), number(rows[k], "filled") / finest - 1);
  }
  return number(rows.back(), "seconds");
}

using diefill::render::Curve;
using diefill::render::CurveStyle;

constexpr double kMin = 1e-3;  // below it, errors are drawn there

double drawn(double error) {
  return 100 * std::max(kMin, error);
}

/// What a share of the cases of each way does not exceed, at the median of their times: a reference, joined
/// within a series.
Curve quantile_line(const std::vector<Way>& ways, const std::string& name, double share) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  Curve curve;
  curve.name = name;
  curve.style = CurveStyle::kReference;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (k > 0 && ways[k].series != ways[k - 1].series) {
      curve.x.push_back(kGap);
      curve.y.push_back(kGap);
    }
    curve.x.push_back(quantile(ways[k].seconds, 0.5));
    curve.y.push_back(drawn(quantile(ways[k].errors, share)));
  }
  return curve;
}

/// A line at the cost of the finest fill, s.
Curve finest_fill(double seconds) {
  Curve curve;
  curve.name = "the finest fill: narrow ring, d/b = 0.189";
  curve.style = CurveStyle::kReference;
  curve.x = {seconds, seconds};
  curve.y = {drawn(0), 100};
  return curve;
}

/// Single cases, and the median and the 90th percentile of each way; `finest`: s of the finest fill.
diefill::render::Chart chart_of(const std::vector<Way>& ways, double finest) {
  diefill::render::Chart chart;
  chart.title = "Cost against error of the mass in the cavity";
  chart.subtitle =
      "estimates against runs of the same grains; runs against grains of no size; the ring against its "
      "finest "
      "fill";
  chart.note =
      "Single cases; errors below 0.1 % are drawn there. Estimates: wall time of one thread. The finest fill "
      "(grains of 0.47 mm, half of the ring) took 4,500 CPU hours in 2009 (1.6e7 s, whole ring).";
  chart.x.label = "Processor time [s]";
  chart.x.logarithmic = true;
  chart.y.label = "Error [%]";
  chart.y.logarithmic = true;
  for (const Way& way : ways) {
    Curve curve;
    curve.name = way.name;
    curve.style = CurveStyle::kMarkers;
    curve.x = way.seconds;
    for (const double error : way.errors) curve.y.push_back(drawn(error));
    chart.curves.push_back(curve);
  }
  chart.curves.push_back(quantile_line(ways, "median error of each method", 0.5));
  chart.curves.push_back(quantile_line(ways, "90th percentile of each method's error", 0.9));
  chart.curves.push_back(finest_fill(finest));
  return chart;
}

void write_table(const std::string& file, const std::vector<Way>& ways) {
  std::ofstream text(file);
  text << "way,cases,median_seconds,median_error,error_of_nine_in_ten\n";
  for (const Way& way : ways) {
    char line[200];
    std::snprintf(line, sizeof line, "\"%s\",%zu,%.3g,%.3g,%.3g\n", way.name.c_str(), way.errors.size(),
                  quantile(way.seconds, 0.5), quantile(way.errors, 0.5), quantile(way.errors, 0.9));
    text << line;
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) {
    std::fprintf(stderr,
                 "cost_chart: expected AGAINST_RUNS.csv GRAIN_SIZE_ERRORS.csv RING_SIZES.csv FOLDER\n");
    return 2;
  }
  diefill::render::start_offscreen(count, words);
  std::vector<Way> ways;
  add_estimates(rows_of(words[1]), ways);
  add_runs(rows_of(words[2]), ways);
  const double finest = add_ring(rows_of(words[3]), ways);
  const std::string folder = words[4];
  write_table(folder + "/cost_against_error.csv", ways);
  diefill::render::draw_chart(folder + "/cost_against_error.png", chart_of(ways, finest));
  return 0;
}
