#include "app/pictures/discharge_chart.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "process/results/rounding.h"
#include "render/charts/chart.h"

namespace diefill::app {

namespace {

namespace continuum = process::continuum;
using continuum::DischargeLaw;
using continuum::DischargePoint;

constexpr int kLinePoints = 200;
constexpr double kGrams = 1e3;

/// What runs along x, in the chart's unit: m/s, ms or mm.
double abscissa(DischargeLaw law, const DischargePoint& point) {
  if (is_of_rates(law)) return 1e3 * point.width;
  return law == DischargeLaw::transient ? 1e3 * point.time : point.speed;
}

void set_abscissa(DischargeLaw law, double value, DischargePoint& point) {
  if (is_of_rates(law))
    point.width = 1e-3 * value;
  else
    (law == DischargeLaw::transient ? point.time : point.speed) =
        law == DischargeLaw::transient ? 1e-3 * value : value;
}

std::string x_label(DischargeLaw law) {
  if (law == DischargeLaw::transient) return "Time since the slit opened [ms]";
  if (law == DischargeLaw::beverloo_round) return "Diameter of the hole [mm]";
  return law == DischargeLaw::beverloo_slit ? "Width of the slit [mm]" : "Shoe speed [m/s]";
}

std::string title_of(DischargeLaw law) {
  if (law == DischargeLaw::transient) return "Mass over time";
  if (law == DischargeLaw::beverloo_round) return "Discharge rate over the diameter of the hole";
  return law == DischargeLaw::beverloo_slit ? "Discharge rate over the width of the slit"
                                            : "Mass over shoe speed";
}

/// Whether a number is known to less than half of itself, as remarks() say too.
bool vague(const continuum::DischargeFit& fit) {
  for (Eigen::Index k = 0; k < fit.fit.numbers.size(); ++k)
    if (std::sqrt(std::max(0.0, fit.fit.covariance(k, k))) > 0.5 * std::abs(fit.fit.numbers[k])) return true;
  return false;
}

/// One standard deviation of the law at `point`, from the covariance of its numbers as they were fitted.
double band_at(const continuum::DischargeFit& fit, const continuum::DischargeData& data,
               const DischargePoint& point) {
  continuum::DischargeFit moved = fit;  // without its points: line_of()
  const Eigen::VectorXd& at = fit.fit.fitted;
  Eigen::VectorXd slope(at.size());
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const double step = 1e-5 * std::max(1e-6, std::abs(at[k]));
    moved.fit.fitted = at;
    moved.fit.fitted[k] += step;
    const double above = continuum::predicted(moved, data, point);
    moved.fit.fitted[k] -= 2 * step;
    slope[k] = (above - continuum::predicted(moved, data, point)) / (2 * step);
  }
  return std::sqrt(std::max(0.0, slope.dot(fit.fit.fitted_covariance * slope)));
}

/// The points of one slit.
render::Curve measured(const continuum::DischargeFit& fit, const std::vector<DischargePoint>& points,
                       const std::string& name) {
  render::Curve curve;
  curve.name = name;
  curve.style = fit.law == DischargeLaw::transient ? render::CurveStyle::kLine : render::CurveStyle::kMarkers;
  const bool known =
      std::all_of(points.begin(), points.end(), [](const auto& point) { return point.error > 0; });
  for (const auto& point : points) {
    curve.x.push_back(abscissa(fit.law, point));
    curve.y.push_back(kGrams * point.value);
    if (known) curve.y_error.push_back(kGrams * point.error);
  }
  return curve;
}

render::Curve line_of(const continuum::DischargeFit& fit, const continuum::DischargeData& data,
                      const std::vector<DischargePoint>& points, const std::string& name) {
  render::Curve curve;
  curve.name = name;
  const auto by_x = [&](const auto& a, const auto& b) { return abscissa(fit.law, a) < abscissa(fit.law, b); };
  const auto [first, last] = std::minmax_element(points.begin(), points.end(), by_x);
  const double from = abscissa(fit.law, *first), to = abscissa(fit.law, *last);
  DischargePoint point = points.front();
  continuum::DischargeFit law = fit;
  law.used.clear();
  for (int k = 0; k <= kLinePoints; ++k) {
    const double x = from + (to - from) * k / kLinePoints;
    set_abscissa(fit.law, x, point);
    curve.x.push_back(x);
    curve.y.push_back(kGrams * continuum::predicted(law, data, point));
    curve.band.push_back(kGrams * band_at(law, data, point));
  }
  return curve;
}

std::string numbers_text(const continuum::DischargeFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < fit.names.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    text += (k == 0 ? "" : ", ") + fit.names[k] + " = " +
            results::with_scatter(fit.fit.numbers[i], std::sqrt(std::max(0.0, fit.fit.covariance(i, i))));
  }
  return text;
}

}  // namespace

void draw_discharge(const std::filesystem::path& png, const continuum::DischargeFit& fit,
                    const continuum::DischargeData& data) {
  render::Chart chart;
  chart.title = title_of(fit.law);
  chart.subtitle = "Law " + continuum::name_of(fit.law) + ": " + numbers_text(fit);
  chart.x.label = x_label(fit.law);
  chart.y.label = continuum::is_of_rates(fit.law) ? "Rate [g/s]" : "Mass [g]";
  chart.note = continuum::formula_of(fit.law) + ". Band: one standard deviation.";
  if (vague(fit)) chart.note += " The curve is better determined than its parameters.";
  std::map<double, std::vector<DischargePoint>> slits;
  for (const auto& point : fit.used)
    slits[continuum::is_of_rates(fit.law) ? 0 : point.width].push_back(point);
  for (const auto& [width, points] : slits) {
    const std::string slit =
        slits.size() < 2 ? "" : ", slit of " + results::in_significant_digits(1e3 * width, 3) + " mm";
    chart.curves.push_back(line_of(fit, data, points, "fit, band: one standard deviation" + slit));
    chart.curves.push_back(measured(fit, points, "measured" + slit));
  }
  render::draw_chart(png, chart);
}

}  // namespace diefill::app
