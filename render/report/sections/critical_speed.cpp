#include "render/report/sections/critical_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/results/full_die.h"
#include "process/results/none.h"
#include "process/results/studies/quantiles.h"
#include "render/report/figure_text.h"
#include "render/report/numbers.h"

namespace diefill::render::report {
namespace {

constexpr double kNormalQuantile = 1.96;  // 95 %

/// A straight line w = intercept + slope u through points.
struct Line {
  std::vector<double> u, w, error;
  double intercept = 0, slope = 0, middle = 0, spread = 0;

  bool fit() {
    const auto n = static_cast<double>(u.size());
    double level = 0, product = 0;
    for (std::size_t k = 0; k < u.size(); ++k) {
      middle += u[k] / n;
      level += w[k] / n;
    }
    for (std::size_t k = 0; k < u.size(); ++k) {
      spread += (u[k] - middle) * (u[k] - middle);
      product += (u[k] - middle) * (w[k] - level);
    }
    if (u.size() < 2 || !(spread > 1e-12)) return false;
    slope = product / spread;
    intercept = level - slope * middle;
    return slope < 0;
  }
  double zero() const { return -intercept / slope; }
  /// By how much the zero moves as w[k] does.
  double sensitivity(std::size_t k) const {
    const double of_slope = (u[k] - middle) / spread;
    const double of_intercept = 1 / static_cast<double>(u.size()) - of_slope * middle;
    return (-of_intercept * slope + intercept * of_slope) / (slope * slope);
  }
};

/// Half width of the 95 % interval of the line's zero.
double half_width(const Line& line) {
  double squares = 0, residuals = 0, from_errors = 0;
  bool known = true;
  for (std::size_t k = 0; k < line.u.size(); ++k) {
    const double by = line.sensitivity(k);
    squares += by * by;
    residuals += std::pow(line.w[k] - line.intercept - line.slope * line.u[k], 2);
    from_errors += by * by * line.error[k] * line.error[k];
    known = known && std::isfinite(line.error[k]);
  }
  double width = known ? kNormalQuantile * std::sqrt(from_errors) : kNone;
  if (line.u.size() > 2) {
    const double freedom = static_cast<double>(line.u.size() - 2);
    const double own = results::student_95(freedom) * std::sqrt(residuals / freedom * squares);
    width = known ? std::max(width, own) : own;
  }
  return width;
}

/// Sorts out full and incomplete runs; points of the line in logarithms.
Line line_of(const std::vector<double>& speed, const std::vector<double>& ratio,
             const std::vector<double>& error, CriticalSpeed& result) {
  Line line;
  for (std::size_t n = 0; n < speed.size(); ++n) {
    if (!(speed[n] > 0) || !(ratio[n] > 0)) continue;
    if (results::is_full(ratio[n])) {
      if (!(result.fastest_full > speed[n])) result.fastest_full = speed[n];
      continue;
    }
    if (!(result.slowest_incomplete < speed[n])) result.slowest_incomplete = speed[n];
    line.u.push_back(std::log(speed[n]));
    line.w.push_back(std::log(ratio[n]));
    line.error.push_back(n < error.size() ? error[n] / ratio[n] : kNone);
    ++result.points;
  }
  return line;
}

std::string metres_per_second(double speed) {
  return shown("shoe_speed_m_s", speed);
}

}  // namespace

CriticalSpeed critical_speed(const std::vector<double>& speed, const std::vector<double>& fill_ratio,
                             const std::vector<double>& error) {
  CriticalSpeed result{kNone, kNone, 0, kNone, kNone, kNone, kNone};
  Line line = line_of(speed, fill_ratio, error, result);
  if (!line.fit()) return result;
  result.exponent = -line.slope;
  result.speed = std::exp(line.zero());
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0;
  for (std::size_t n = 0; n < speed.size(); ++n) {
    if (!(speed[n] > 0) || !(fill_ratio[n] > 0)) continue;
    slowest = std::min(slowest, speed[n]);
    fastest = std::max(fastest, speed[n]);
  }
  constexpr double kRounding = 1e-9;
  result.extrapolation = std::max({1.0, slowest / result.speed, result.speed / fastest});
  result.too_far = result.extrapolation > kFarthest * (1 + kRounding);
  if (result.too_far) {
    result.speed = result.exponent = kNone;
    return result;
  }
  const double width = half_width(line);
  result.lower = std::exp(line.zero() - width);
  result.upper = std::exp(line.zero() + width);
  return result;
}

std::string description(const CriticalSpeed& critical) {
  std::string runs;
  if (std::isfinite(critical.fastest_full))
    runs +=
        " The die was full up to " + metres_per_second(critical.fastest_full) + " (fill ratio 0.98 or more).";
  if (std::isfinite(critical.slowest_incomplete))
    runs += " From " + metres_per_second(critical.slowest_incomplete) + " on it was not full.";
  if (critical.too_far)
    return "No critical speed: the estimate is " + in_digits(critical.extrapolation, 2) +
           " times beyond the simulated speeds, and extrapolation is limited to " + in_digits(kFarthest, 2) +
           " times. Run speeds closer to it." + runs;
  if (!std::isfinite(critical.speed))
    return "These runs do not determine a critical speed: at least two speeds with incomplete filling (fill "
           "ratio below 0.98) are needed, the faster one with the lower fill ratio." +
           runs;
  std::string text = "Fill ratio 1 is reached up to about v_c = " + metres_per_second(critical.speed);
  text += std::isfinite(critical.lower)
              ? ", 95 % interval " + metres_per_second(critical.lower) + " to " +
                    metres_per_second(critical.upper)
              : ", interval unknown (two speeds of one seed: the curve passes through both)";
  if (critical.extrapolation > 1)
    text += "; extrapolated " + in_digits(critical.extrapolation, 2) + " times beyond the simulated speeds";
  return text + ". Fill ratio = (v_c / v)^n with n = " + in_digits(critical.exponent, 2) + ", from " +
         std::to_string(critical.points) +
         " speeds with incomplete filling (Sinka, Schneider and Cocks 2004)." + runs;
}

}  // namespace diefill::render::report
