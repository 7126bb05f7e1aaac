#include "process/continuum/discharge_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "process/continuum/cumulated_mass.h"
#include "process/input/units.h"
#include "process/powder/empty_annulus.h"

namespace diefill::process::continuum {

namespace {

constexpr std::size_t kWidthsForAnnulus = 3;  // to fit it

double effective_width_of(const DischargePoint& point, const DischargeData& data) {
  return effective_width(point.width, data.grain_diameter);
}

/// t sqrt(g/D) - 1/5 of a point of a transient law.
double x_of(DischargeLaw law, const DischargePoint& point, const DischargeData& data) {
  const double width = effective_width_of(point, data);
  return (law == DischargeLaw::transient ? point.time * std::sqrt(data.gravity / width)
                                         : std::sqrt(data.gravity * width) / point.speed) -
         kBurst;
}

/// kg that f_B is multiplied by.
double scale_of(DischargeLaw law, const DischargePoint& point, const DischargeData& data) {
  const double width = effective_width_of(point, data);
  return data.density * width * point.length * (law == DischargeLaw::transient ? width : point.shoe_length);
}

bool has_burst(DischargeLaw law) {
  return law == DischargeLaw::moving_shoe || law == DischargeLaw::transient;
}

/// Whether the point is in the range of the law.
bool within_range(DischargeLaw law, const DischargePoint& point, const DischargeData& data) {
  if (!is_of_rates(law) && !(effective_width_of(point, data) > 0)) return false;
  return !has_burst(law) || x_of(law, point, data) >= 0;
}

/// f_B is linear in C_B, C_F and C_F - C_I for a given beta.
SeparableModel burst_model(DischargeLaw law, const DischargeData& data) {
  SeparableModel model;
  model.names = {"C_B", "C_I", "C_F", "beta"};
  model.least_shape = 1e-3;
  model.largest_shape = 100;
  model.basis = [law, &data](double beta) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(data.points.size()), 3);
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
      const auto& point = data.points[static_cast<std::size_t>(i)];
      const double x = x_of(law, point, data);
      basis.row(i) = scale_of(law, point, data) * Eigen::RowVector3d(1, x, std::expm1(-beta * x) / beta);
    }
    return basis;
  };
  model.meaning = [](const Eigen::VectorXd& c) -> Eigen::VectorXd {
    return Eigen::Vector4d(c[0], c[1] - c[2], c[1], c[3]);
  };
  return model;
}

/// C_S times a power of sqrt(gD) / v_s; the shape is 1 + n.
SeparableModel power_model(const DischargeData& data) {
  SeparableModel model;
  model.names = {"C_S", "n"};
  model.least_shape = 0.1;
  model.largest_shape = 10;
  model.basis = [&data](double exponent) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(data.points.size()), 1);
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
      const auto& point = data.points[static_cast<std::size_t>(i)];
      const double ratio = std::sqrt(data.gravity * effective_width_of(point, data)) / point.speed;
      basis(i, 0) = scale_of(DischargeLaw::power_law, point, data) * std::pow(ratio, exponent);
    }
    return basis;
  };
  model.meaning = [](const Eigen::VectorXd& c) -> Eigen::VectorXd { return Eigen::Vector2d(c[0], c[1] - 1); };
  return model;
}

std::size_t widths_of(const DischargeData& data) {
  std::set<double> widths;
  for (const auto& point : data.points) widths.insert(point.width);
  return widths.size();
}

/// C rho sqrt(g) (D - k d)^(5/2), or b times ^(3/2); the shape is k.
SeparableModel beverloo_model(DischargeLaw law, const DischargeData& data) {
  SeparableModel model;
  model.names = {"C"};
  model.least_shape = model.largest_shape = kEmptyAnnulus;
  if (data.grain_diameter > 0 && widths_of(data) >= kWidthsForAnnulus) {
    model.names.emplace_back("k");
    model.least_shape = 0.05;
    model.largest_shape = 5;
  }
  const bool round = law == DischargeLaw::beverloo_round;
  model.basis = [round, &data](double k) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(data.points.size()), 1);
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
      const auto& point = data.points[static_cast<std::size_t>(i)];
      const double width = std::max(0.0, point.width - k * data.grain_diameter);
      basis(i, 0) = data.density * std::sqrt(data.gravity) *
                    (round ? std::pow(width, 2.5) : point.length * std::pow(width, 1.5));
    }
    return basis;
  };
  return model;
}

SeparableModel model_of(DischargeLaw law, const DischargeData& data) {
  if (has_burst(law)) return burst_model(law, data);
  return law == DischargeLaw::power_law ? power_model(data) : beverloo_model(law, data);
}

/// Refuses openings that the empty annulus closes: no law describes the flow through them.
void refuse_closed(DischargeLaw law, const DischargeData& data) {
  const bool fits_annulus = is_of_rates(law) && widths_of(data) >= kWidthsForAnnulus;
  if (!(data.grain_diameter > 0) || fits_annulus) return;
  for (const auto& point : data.points)
    if (!(effective_width_of(point, data) > 0))
      throw std::invalid_argument("found an opening of " + number_text(1e3 * point.width) +
                                  " mm with grains of " + number_text(1e3 * data.grain_diameter) +
                                  " mm, allowed: more than " + number_text(kEmptyAnnulus) +
                                  " grain diameters, because powder does not flow through narrower ones; "
                                  "check width and grain diameter, or remove the points of this opening");
}

/// Whether a parameter that is at least 0 in any flow is negative by more than its uncertainty.
bool is_negative(const DischargeFit& found, const std::string& name) {
  const auto k = static_cast<Eigen::Index>(std::find(found.names.begin(), found.names.end(), name) -
                                           found.names.begin());
  const double value = found.fit.numbers[k], deviation = std::sqrt(std::max(0.0, found.fit.covariance(k, k)));
  return value < 0 && !(value + deviation >= 0 && deviation < found.number("C_F"));
}

void refuse_too_few(const SeparableModel& model, std::size_t given, std::size_t left) {
  const std::size_t least = model.names.size() + 1;
  if (left < least && left < given)
    throw std::invalid_argument("found " + std::to_string(left) + (left == 1 ? " point" : " points") +
                                " in the range of the law, allowed: at least " + std::to_string(least) +
                                "; at the other " + std::to_string(given - left) +
                                " the flow has not started (shoe faster than 5 sqrt(gD), or time before "
                                "sqrt(D/g)/5); measure at lower speeds or later");
}

/// Refuses points that are all at one speed or time, or have all one mass, and an outflow that never rises.
/// Rates through openings may be all of one width.
void refuse_constant(DischargeLaw law, const DischargeData& data) {
  if (is_of_rates(law) || data.points.empty()) return;
  const bool over_time = law == DischargeLaw::transient;
  const DischargePoint& first = data.points.front();
  const auto all = [&](const auto& holds) {
    return std::all_of(data.points.begin(), data.points.end(), holds);
  };
  const std::string variable = over_time ? "time" : "speed";
  if (all([&](const auto& point) { return x_of(law, point, data) == x_of(law, first, data); }))
    throw std::invalid_argument("column " + variable + ": all points have the same " + variable +
                                ", allowed: several; measure at others");
  if (all([&](const auto& point) { return point.value == first.value; }))
    throw std::invalid_argument("column mass: all points have " + number_text(1e3 * first.value) +
                                " g, allowed: masses that change with the " + variable +
                                "; check the column and the points");
  const auto earliest = std::min_element(data.points.begin(), data.points.end(),
                                         [](const auto& a, const auto& b) { return a.time < b.time; });
  if (over_time && all([&](const auto& point) { return point.value <= earliest->value; }))
    throw std::invalid_argument(
        "column mass: no point has more than the first in time, allowed: the mass that has run out, which "
        "rises; check whether the column is what is left in the hopper");
}

void refuse_unphysical(const DischargeFit& found) {
  const auto refuse = [&](const std::string& name, const std::string& allowed, const std::string& meaning) {
    throw std::invalid_argument(
        "the points give " + name + " = " + number_text(found.number(name)) + ", allowed: " + allowed +
        ", as " + meaning + "; check the points for errors, measure more points, or fit another law (--law)" +
        (found.law == DischargeLaw::transient ? "; exclude the points after the hopper has emptied (--until)"
                                              : ""));
  };
  if (has_burst(found.law)) {
    if (!(found.number("C_F") > 0)) refuse("C_F", "above 0", "it is the rate of the steady flow");
    if (is_negative(found, "C_I")) refuse("C_I", "0 or more", "it is the initial rate of the flow");
    if (is_negative(found, "C_B")) refuse("C_B", "0 or more", "it is the mass of the initial burst");
    return;
  }
  const std::string factor = found.names.front();
  if (!(found.number(factor) > 0)) refuse(factor, "above 0", "the whole flow is proportional to it");
  if (found.law == DischargeLaw::power_law && found.fit.shape_at_bound)
    refuse("n", "-0.9 to 9", "the discharged mass decreases with a power of the speed");
}

/// Points of each outflow over time: those of one width, until the time does not rise.
std::vector<Outflow> outflows_of(const DischargeData& data) {
  std::vector<Outflow> outflows;
  std::map<double, std::size_t> current;  // by width
  for (std::size_t k = 0; k < data.points.size(); ++k) {
    const DischargePoint& point = data.points[k];
    const auto found = current.find(point.width);
    if (found == current.end() ||
        !(point.time > data.points[static_cast<std::size_t>(outflows[found->second].back())].time)) {
      current[point.width] = outflows.size();
      outflows.emplace_back();
    }
    outflows[current[point.width]].push_back(static_cast<Eigen::Index>(k));
  }
  return outflows;
}

/// Errors of the masses that have run out over time; none of other laws, whose points are independent.
CovarianceOfSums shared_errors(DischargeLaw law, const DischargeData& data, const Eigen::VectorXd& measured,
                               std::size_t fitted_numbers) {
  if (law != DischargeLaw::transient) return {};
  return [=, outflows = outflows_of(data)](const Eigen::MatrixXd& sums, const Eigen::VectorXd& fitted) {
    const double scatter =
        variance_per_mass(outflows, measured, fitted, static_cast<Eigen::Index>(fitted_numbers));
    return covariance_of_sums(sums, outflows, fitted, scatter);
  };
}

/// Sums round as their order goes: points that are independent are fitted in one order, whichever they come
/// in. That of points over time tells their outflows apart.
void put_in_order(DischargeLaw law, std::vector<DischargePoint>& points) {
  if (law == DischargeLaw::transient) return;
  const auto key = [](const DischargePoint& p) {
    return std::tie(p.width, p.speed, p.length, p.shoe_length, p.value, p.error);
  };
  std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

double largest_value(const DischargeData& data) {
  double largest = 0;
  for (const auto& point : data.points) largest = std::max(largest, point.value);
  return largest;
}

}  // namespace

double DischargeFit::number(const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::out_of_range("no number " + name);
  return fit.numbers[at - names.begin()];
}

DischargeFit fit_discharge(DischargeLaw law, const DischargeData& given) {
  refuse_closed(law, given);
  DischargeData data = given;
  std::erase_if(data.points, [&](const auto& point) { return !within_range(law, point, given); });
  put_in_order(law, data.points);
  const SeparableModel model = model_of(law, data);
  refuse_too_few(model, given.points.size(), data.points.size());
  if (data.points.size() > model.names.size()) refuse_constant(law, data);
  const auto count = static_cast<Eigen::Index>(data.points.size());
  const bool known =
      std::all_of(data.points.begin(), data.points.end(), [](const auto& point) { return point.error > 0; });
  Eigen::VectorXd y(count), sigma(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& point = data.points[static_cast<std::size_t>(i)];
    y[i] = point.value;
    sigma[i] =
        known ? point.error : (law == DischargeLaw::transient ? largest_value(data) : std::abs(point.value));
  }
  DischargeFit found;
  found.law = law;
  found.names = model.names;
  found.fit = fit(model, y, sigma, !known, shared_errors(law, data, y, model.names.size()));
  found.left_out = given.points.size() - data.points.size();
  for (Eigen::Index i = 0; i < count; ++i) {
    found.relative_scatter += std::pow(y[i] / found.fit.values[i] - 1, 2) / static_cast<double>(count);
    if (!is_of_rates(law))
      found.largest_x = std::max(found.largest_x, x_of(law, data.points[static_cast<std::size_t>(i)], data));
  }
  found.relative_scatter = std::sqrt(found.relative_scatter);
  found.used = data.points;
  refuse_unphysical(found);
  return found;
}

double predicted(const DischargeFit& fit, const DischargeData& data, const DischargePoint& point) {
  const DischargeData one{{point}, data.density, data.grain_diameter, data.gravity};
  if (!within_range(fit.law, point, data)) return std::nan("");
  const bool shaped = fit.names.back() != "C";
  const SeparableModel model = model_of(fit.law, one);
  const Eigen::Index linear = fit.fit.fitted.size() - (shaped ? 1 : 0);
  const double shape = shaped ? fit.fit.fitted[linear] : kEmptyAnnulus;
  return (model.basis(shape) * fit.fit.fitted.head(linear))[0];
}

}  // namespace diefill::process::continuum
