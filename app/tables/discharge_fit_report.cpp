#include "app/tables/discharge_fit_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "process/input/units.h"
#include "process/powder/empty_annulus.h"
#include "process/results/csv_field.h"
#include "process/results/json_numbers.h"
#include "process/results/rounding.h"

namespace diefill::app {

namespace {

using Json = nlohmann::ordered_json;
namespace continuum = process::continuum;

/// Deviation over value from which on a number says little.
constexpr double kLargestRelativeDeviation = 0.5;
/// chi^2 per degree of freedom from which on errors do not explain the scatter.
constexpr double kMisfit = 4;

double deviation(const continuum::DischargeFit& fit, std::size_t k) {
  const auto i = static_cast<Eigen::Index>(k);
  return std::sqrt(std::max(0.0, fit.fit.covariance(i, i)));
}

/// Grain diameters that an opening counts less: k where it is fitted.
double annulus_of(const continuum::DischargeFit& fit) {
  const bool fitted = std::find(fit.names.begin(), fit.names.end(), "k") != fit.names.end();
  return fitted ? fit.number("k") : process::kEmptyAnnulus;
}

/// A factor of the flow, and between which values powders have it.
struct UsualFactor {
  const char* name;
  double least, most;
};

UsualFactor usual_factor(const continuum::DischargeFit& fit) {
  if (is_of_rates(fit.law)) return {"C", 0.1, 3};
  return fit.law == continuum::DischargeLaw::power_law ? UsualFactor{"C_S", 0.01, 10}
                                                       : UsualFactor{"C_F", 0.05, 20};
}

/// The remark on a factor that no powder has; empty: it is a usual one.
std::string unit_remark(const continuum::DischargeFit& fit) {
  const auto [name, least, most] = usual_factor(fit);
  const double factor = fit.number(name);
  // A C_F that the points do not determine may have any value, the rate that they end with has not.
  const double at_end =
      fit.names.front() == "C_B"
          ? continuum::rate_share({fit.number("C_B"), fit.number("C_I"), factor, fit.number("beta")},
                                  fit.largest_x)
          : factor;
  if ((factor >= least && factor <= most) || (at_end >= least && at_end <= most)) return {};
  return name + (" = " + results::in_significant_digits(factor, 3)) +
         " is outside the range known for powders, " + process::number_text(least) + " to " +
         process::number_text(most) + ": check the units of density, " +
         (is_of_rates(fit.law) ? "rate" : "mass") +
         " and width, in the heading of the table and in the options";
}

/// Whether the mass rises in the last fifth of the time by less than a quarter of its mean rate.
bool ends_flat(std::vector<continuum::DischargePoint> curve) {
  constexpr double kLast = 0.2, kOfMeanRate = 0.25;
  const auto by_time = [](const auto& one, const auto& other) { return one.time < other.time; };
  std::sort(curve.begin(), curve.end(), by_time);
  const auto &first = curve.front(), &last = curve.back();
  if (!(last.time > first.time)) return false;
  continuum::DischargePoint then;
  then.time = last.time - kLast * (last.time - first.time);
  const auto& before = *std::prev(std::upper_bound(curve.begin(), curve.end(), then, by_time));
  return (last.value - before.value) / (last.time - before.time) <
         kOfMeanRate * (last.value - first.value) / (last.time - first.time);
}

/// The same of one of several slits.
bool any_ends_flat(const continuum::DischargeFit& fit) {
  std::map<double, std::vector<continuum::DischargePoint>> slits;
  for (const auto& point : fit.used) slits[point.width].push_back(point);
  return std::any_of(slits.begin(), slits.end(), [](const auto& slit) { return ends_flat(slit.second); });
}

/// Null without errors: the deviations then follow from the scatter itself.
Json chi_square(const continuum::DischargeFit& fit) {
  if (!(fit.used.front().error > 0)) return nullptr;
  return results::json_number(fit.fit.chi_square_per_freedom);
}

}  // namespace

std::vector<std::string> doubts(const continuum::DischargeFit& fit) {
  std::vector<std::string> lines;
  if (const std::string remark = unit_remark(fit); !remark.empty()) lines.push_back(remark);
  if (fit.used.front().error > 0 && fit.fit.chi_square_per_freedom > kMisfit)
    lines.emplace_back(
        "the points deviate from the fit by far more than their errors: this law does not describe them; try "
        "another");
  if (fit.law == continuum::DischargeLaw::transient && any_ends_flat(fit))
    lines.emplace_back(
        "the mass hardly rises in the last fifth of the time, as once the hopper is empty, which makes C_F "
        "and beta wrong; leave it out with --until");
  return lines;
}

std::vector<std::string> remarks(const continuum::DischargeFit& fit) {
  std::vector<std::string> lines = doubts(fit);
  if (fit.left_out > 0)
    lines.push_back(std::to_string(fit.left_out) +
                    " points left out: the flow has not begun there (x below 0: faster than 5 sqrt(gD), or "
                    "earlier than sqrt(D/g)/5)");
  if (fit.fit.shape_at_bound)
    lines.push_back(
        fit.names.back() + " is at the limit of the search range: the points do not show how the flow " +
        (is_of_rates(fit.law) ? "depends on the size of the opening" : "comes to its steady rate") +
        "; the fit holds where it was measured and not beyond");
  for (std::size_t k = 0; k < fit.names.size(); ++k)
    if (const double share = deviation(fit, k) / std::abs(fit.fit.numbers[static_cast<Eigen::Index>(k)]);
        share > kLargestRelativeDeviation)
      lines.push_back(
          fit.names[k] +
          (share > 1 ? " is not determined by these data"
                     : " is known to within " + results::in_significant_digits(100 * share, 2) + " % only") +
          "; the curve is better determined than its parameters, see the band of the chart");
  if (fit.law == continuum::DischargeLaw::transient)
    lines.emplace_back(
        "the deviations follow from how the mass of this outflow scatters from point to point; another "
        "packing "
        "of the powder may deviate by more: repeat it");
  return lines;
}

void print_fit(const continuum::DischargeFit& fit, const continuum::DischargeData& data) {
  std::printf("law %s: %s\n", continuum::name_of(fit.law).c_str(), continuum::formula_of(fit.law).c_str());
  for (std::size_t k = 0; k < fit.names.size(); ++k)
    std::printf(
        "%s = %s\n", fit.names[k].c_str(),
        results::with_scatter(fit.fit.numbers[static_cast<Eigen::Index>(k)], deviation(fit, k)).c_str());
  std::printf("%zu points; they scatter by %.2g %% about the fit, ", fit.used.size(),
              100 * fit.relative_scatter);
  if (fit.used.front().error > 0)
    std::printf("chi^2 per degree of freedom %.2g\n", fit.fit.chi_square_per_freedom);
  else
    std::printf("which sets the deviations, as no errors are given\n");
  if (data.grain_diameter > 0)
    std::printf("openings count as D - %.4g d with d = %.4g mm\n", annulus_of(fit),
                1e3 * data.grain_diameter);
  for (const auto& remark : remarks(fit)) std::printf("note: %s\n", remark.c_str());
}

Json fit_as_json(const continuum::DischargeFit& fit, const continuum::DischargeData& data,
                 const std::string& file) {
  Json json = {{"law", continuum::name_of(fit.law)},
               {"formula", continuum::formula_of(fit.law)},
               {"measurements", file},
               {"coefficients", Json::object()},
               {"covariance", Json::array()},
               {"points", fit.used.size()},
               {"points_left_out", fit.left_out},
               {"relative_scatter", results::json_number(fit.relative_scatter)},
               {"chi_square_per_degree_of_freedom", chi_square(fit)},
               {"density_kg_m3", data.density},
               {"effective_opening_grain_diameter_m", data.grain_diameter}};
  for (std::size_t k = 0; k < fit.names.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    json["coefficients"][fit.names[k]] = {{"value", results::json_number(fit.fit.numbers[i])},
                                          {"deviation", results::json_number(deviation(fit, k))}};
    Json row = Json::array();
    for (Eigen::Index j = 0; j < fit.fit.covariance.cols(); ++j)
      row.push_back(results::json_number(fit.fit.covariance(i, j)));
    json["covariance"].push_back(row);
  }
  if (!is_of_rates(fit.law)) json["largest_x"] = fit.largest_x;
  json["remarks"] = remarks(fit);
  json["doubts"] = doubts(fit);
  json["holds_beyond_largest_x"] = !fit.fit.shape_at_bound;
  return json;
}

std::string fit_as_csv(const continuum::DischargeFit& fit, const continuum::DischargeData&) {
  const std::string unit = is_of_rates(fit.law) ? "kg/s" : "kg";
  std::string text =
      "speed m/s,time s,width m,measured " + unit + ",fitted " + unit + ",deviation of fit " + unit + "\n";
  for (std::size_t k = 0; k < fit.used.size(); ++k) {
    const auto& point = fit.used[k];
    const auto i = static_cast<Eigen::Index>(k);
    for (const double value : {point.speed, point.time, point.width, point.value, fit.fit.values[i]})
      text += results::csv_number(value) + ",";
    text += results::csv_number(fit.fit.value_errors[i]) + "\n";
  }
  return text;
}

}  // namespace diefill::app
