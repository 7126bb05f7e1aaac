#include "process/laboratory/flow/hopper_figures.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/flow/hopper_models.h"
#include "process/laboratory/flow/hopper_setups.h"
#include "process/results/formatted.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kBulkFrom = 40e-3;  // m, above which powder has its bulk fraction (section 5.1.3)
constexpr double kLoosened = 0.02;   // of the bulk fraction
constexpr double kNegligible = 0.1;  // of the largest |v_x|
constexpr double kProfiles = 0.25;   // D, the lowest of the profiles
constexpr double kIsoline = -0.1;    // m/s (section 5.1.2)
constexpr double kPeakShare = 0.95;  // n_peak over the largest solid fraction (section 5.1.3)
constexpr double kCompared = 0.30;   // solid fraction at which B is given beside B_0
constexpr double kFar = 3;           // D, above which powder sinks as a plug

int row_at(const continuum::HopperGrid& grid, double z) {
  return std::clamp(static_cast<int>(std::lround(z / grid.spacing_z())), 0, grid.rows);
}

/// Mean of what is finite of a field at |x| < `half` (m), in the rows from z = `from` to `to` (m).
double mean_near(const HopperFields& fields, const std::vector<double>& field, double half, double from,
                 double to) {
  double sum = 0, count = 0;
  for (int row = row_at(fields.grid, from); row <= row_at(fields.grid, to); ++row)
    for (int c = 0; c < fields.grid.columns; ++c) {
      const double value = fields.at(field, c, row);
      if (std::abs(fields.grid.x(c)) > half || !std::isfinite(value)) continue;
      sum += value;
      ++count;
    }
  return count > 0 ? sum / count : kNone;
}

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values)
    if (std::isfinite(value)) found = std::max(found, std::abs(value));
  return found;
}

/// A field at x (m) between the columns of a row.
double value_at(const HopperFields& fields, const std::vector<double>& field, double x, int row) {
  const double column = (x + fields.grid.width / 2) / fields.grid.spacing_x() - 0.5;
  const int left = std::clamp(static_cast<int>(std::floor(column)), 0, fields.grid.columns - 2);
  const double share = column - left;
  return (1 - share) * fields.at(field, left, row) + share * fields.at(field, left + 1, row);
}

using Component = std::vector<double> HopperFields::*;

/// A component over sqrt(g D) at x = k D / 20, k = -20 ... 20, and z = `height` D.
std::vector<double> scaled_row(const HopperSetup& setup, const HopperFields& fields, Component component,
                               double height) {
  std::vector<double> row;
  for (int k = -20; k <= 20; ++k)
    row.push_back(value_at(fields, fields.*component, k * setup.equivalent_slit / 20,
                           row_at(fields.grid, height * setup.equivalent_slit)) /
                  speed_scale(setup));
  return row;
}

/// m/s, mean |v_z| over the whole width far above the slit: sqrt(g D^3) / l times a constant (section 5.1.4).
double plug_speed(const HopperSetup& setup, const HopperFields& fields) {
  return std::abs(mean_near(fields, fields.vertical, fields.grid.width, kFar * setup.equivalent_slit,
                            fields.grid.height));
}

double loose_fraction(const HopperSetup& setup, const HopperFields& fields) {
  return mean_near(fields, fields.fraction, setup.equivalent_slit / 2, 0, setup.equivalent_slit / 2);
}

/// Eq. 5.5 with this n_div and the B_0 of the least squares of log B.
continuum::LengthOfFraction length_with(const std::vector<continuum::LengthPoint>& points, double diverging,
                                        double peak) {
  double sum = 0, count = 0;
  for (const auto& point : points) {
    sum += std::log(point.length) + std::log1p(-point.fraction / diverging);
    ++count;
  }
  return {std::exp(sum / count), diverging, peak};
}

/// The smallest n_div with which B at the peak is no more than `longest` (m); `largest` where none is.
double smallest_diverging(const std::vector<continuum::LengthPoint>& points, double peak, double largest,
                          double longest) {
  double low = peak, high = largest;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (length_with(points, middle, peak)(peak) > longest ? low : high) = middle;
  }
  return high;
}

/// Parameters of Eq. 5.5. B_0 and n_div depend on each other, so that B at one solid fraction stands beside
/// B_0; a bound is no measurement of n_div.
std::vector<results::ExperimentFigure> length_figures(const HopperStudy& study) {
  const auto& length = study.length;
  const bool bound = study.length_at_bound;
  const std::string beside =
      results::formatted("B(0.30) = %.3g mm, published 0.773 mm", 1e3 * length(kCompared));
  const std::string at = results::formatted("n_div at its bound, %.4f", length.diverging);
  const std::string below =
      results::formatted("%.3f below the bulk, published 0.012", length.peak / kPeakShare - length.diverging);
  return {{"D07", 1e3 * length.smallest, bound ? beside + "; " + at : beside},
          {"D08", bound ? kNone : length.diverging, bound ? at : below},
          {"D09", length.peak, "95 % of the bulk, as published; not fitted"},
          {"D10", length.smallest / study.setups[0].equivalent_slit, bound ? at : ""}};
}

}  // namespace

FittedLength fit_rising_branch(const std::vector<continuum::LengthPoint>& points, double bulk, double slit) {
  const double peak = kPeakShare * bulk;
  std::vector<continuum::LengthPoint> rising;
  for (const auto& point : points)
    if (point.fraction <= peak && point.length > 0) rising.push_back(point);
  const double best = continuum::fit_length(rising).diverging;
  const double diverging = std::clamp(best, smallest_diverging(rising, peak, bulk, slit), bulk);
  return {length_with(rising, diverging, peak), diverging != best};
}

double height_of_loosening(const HopperFields& fields, double slit, double share) {
  const double bulk = mean_near(fields, fields.fraction, fields.grid.width, kBulkFrom, fields.grid.height);
  for (int row = fields.grid.rows; row >= 0; --row) {
    const double z = row * fields.grid.spacing_z();
    if (mean_near(fields, fields.fraction, slit / 2, z, z) < (1 - share) * bulk) return z;
  }
  return kNone;
}

double height_of_side_flow(const HopperFields& fields, double share) {
  const double limit = share * largest(fields.horizontal);
  for (int row = fields.grid.rows; row >= 0; --row)
    for (int c = 0; c < fields.grid.columns; ++c)
      if (std::abs(fields.at(fields.horizontal, c, row)) >= limit) return row * fields.grid.spacing_z();
  return kNone;
}

double bend_of_isoline(const continuum::HopperGrid& grid, const std::vector<double>& vertical, double speed,
                       double from, double to) {
  std::vector<double> xs, zs;
  for (int row = row_at(grid, from); row <= row_at(grid, to); ++row)
    for (int c = grid.columns / 2; c + 1 < grid.columns; ++c) {
      const double here = vertical[row * grid.columns + c], next = vertical[row * grid.columns + c + 1];
      if (!(here <= speed && next > speed)) continue;
      xs.push_back(grid.x(c) + grid.spacing_x() * (speed - here) / (next - here));
      zs.push_back(row * grid.spacing_z());
      break;
    }
  if (xs.size() < 5) return kNone;
  const auto count = static_cast<double>(xs.size());
  double x = 0, z = 0, xz = 0, zz = 0, squares = 0;
  for (std::size_t k = 0; k < xs.size(); ++k) {
    x += xs[k] / count;
    z += zs[k] / count;
  }
  for (std::size_t k = 0; k < xs.size(); ++k) {
    xz += (xs[k] - x) * (zs[k] - z);
    zz += (zs[k] - z) * (zs[k] - z);
  }
  for (std::size_t k = 0; k < xs.size(); ++k) squares += std::pow(xs[k] - x - xz / zz * (zs[k] - z), 2);
  return std::sqrt(squares / count);
}

double spread_of_collapse(const HopperStudy& study) {
  double spread = 0;
  for (const Component component : {&HopperFields::vertical, &HopperFields::horizontal})
    for (const double height : {0.25, 0.5}) {
      std::vector<std::vector<double>> rows;
      for (std::size_t k = 0; k < study.setups.size(); ++k)
        rows.push_back(scaled_row(study.setups[k], study.fields[k], component, height));
      std::vector<double> mean(rows[0].size(), 0.0);
      for (const auto& row : rows)
        for (std::size_t n = 0; n < row.size(); ++n) mean[n] += row[n] / static_cast<double>(rows.size());
      const double peak = largest(mean);
      for (const auto& row : rows) {
        double squares = 0, count = 0;
        for (std::size_t n = 0; n < row.size(); ++n)
          if (std::isfinite(row[n] - mean[n])) {
            squares += std::pow(row[n] - mean[n], 2);
            ++count;
          }
        spread = std::max(spread, std::sqrt(squares / count) / peak);
      }
    }
  return spread;
}

std::vector<results::ExperimentFigure> hopper_figures(const HopperStudy& study) {
  const HopperSetup& first = study.setups[0];
  const HopperFields& fields = study.fields[0];
  const double d = first.equivalent_slit;
  const double bulk = mean_near(fields, fields.fraction, fields.grid.width, kBulkFrom, fields.grid.height);
  const double lateral = largest(fields.horizontal);
  const ModelError constant = error_of(study.incompressible, fields, kProfiles * d, 2 * d);
  const ModelError varying = error_of(study.compressible, fields, kProfiles * d, 2 * d);
  const auto loose = [&](std::size_t k) { return loose_fraction(study.setups[k], study.fields[k]); };
  const auto far = [&](std::size_t k) {
    return plug_speed(study.setups[k], study.fields[k]) / speed_scale(study.setups[k]);
  };
  std::vector<results::ExperimentFigure> figures = {
      {"D01", bulk, ""},
      {"D02", 1e3 * height_of_loosening(fields, d, kLoosened), "2 % below the bulk above the slit"},
      {"D03", largest(fields.vertical) / lateral, ""},
      {"D04", lateral, ""},
      {"D05",
       bend_of_isoline(fields.grid, fields.vertical, kIsoline, 0.1 * d, d) /
           bend_of_isoline(fields.grid, study.incompressible.vertical, kIsoline, 0.1 * d, d),
       "v_z = -0.1 m/s, z = 0.1 to 1 D, distance from a straight line"},
      {"D06", height_of_side_flow(fields, kNegligible) / d, "a tenth of the largest"},
      {"D11", varying.horizontal / constant.horizontal, "z = 0.25 to 2 D"},
      {"D12", plug_speed(first, fields), "mean above 3 D"},
      {"D13", spread_of_collapse(study), ""},
      {"D14", std::max(far(1), far(4)) / ((far(0) + far(2) + far(3)) / 3), "mean above 3 D"},
      {"D15", std::max(loose(1), loose(3)) - std::min({loose(0), loose(2), loose(4)}), ""}};
  for (auto& figure : length_figures(study)) figures.push_back(std::move(figure));
  std::sort(figures.begin(), figures.end(),
            [](const auto& one, const auto& other) { return one.id < other.id; });
  for (auto& figure : figures) {
    const bool compares = figure.id == "D13" || figure.id == "D14" || figure.id == "D15";
    figure.grain_diameter = study.setups[compares ? 3 : 0].powder.grain_diameter;
  }
  return figures;
}

}  // namespace diefill::process::laboratory
