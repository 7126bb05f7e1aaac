// Laws of discharge fitted to measurements: masses that a moving shoe leaves at several speeds, rates through
// openings of several widths, or the mass that runs out of an opened slit over time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/continuum/discharge.h"
#include "process/continuum/discharge_law.h"
#include "process/continuum/separable_fit.h"

namespace diefill::process::continuum {

/// One measurement. SI units; what its law does not need may be 0.
struct DischargePoint {
  double value = 0;        ///< kg; kg/s of laws of rates
  double error = 0;        ///< of the same; one standard deviation; 0: not known
  double speed = 0;        ///< m/s, of the shoe
  double time = 0;         ///< s since the slit opened
  double width = 0;        ///< m, D: of the slit along the way of the shoe, or the diameter of the hole
  double length = 0;       ///< m, b: of the slit across
  double shoe_length = 0;  ///< m, l
};

/// Measurements with what is common to all.
struct DischargeData {
  std::vector<DischargePoint> points;
  double density = 0;         ///< kg/m^3, apparent
  double grain_diameter = 0;  ///< m; openings count as D - 1.4 d; 0: as they are
  double gravity = kStandardGravity;
};

/// A fitted law.
struct DischargeFit {
  DischargeLaw law = DischargeLaw::moving_shoe;
  std::vector<std::string> names;  ///< of the numbers
  SeparableFit fit;
  double largest_x = 0;         ///< of t sqrt(g/D) - 1/5 among the points; 0 for Beverloo's laws
  double relative_scatter = 0;  ///< root mean square of (value - fit) / fit
  std::size_t left_out = 0;     ///< points before the flow begins, or beyond 5 sqrt(g D)
  std::vector<DischargePoint>
      used;  ///< the points that were fitted, by rising width and speed but for outflows

  double number(const std::string& name) const;
};

/// Fits the law. The order of the points counts only for the transient law, where it tells outflows of one
/// width apart; other laws give the same to the last bit for any order. Points without errors count with
/// equal relative errors, those over time with equal ones. The covariance of the transient law takes the mass
/// of an outflow, points of one width with rising times, as a random walk (cumulated_mass.h). The effective
/// opening's factor of a Beverloo law (1.4 otherwise) is fitted where a grain diameter is given and there are
/// three widths. Throws std::invalid_argument, in one line, where the points do not determine it, where an
/// opening lets no grain through, and where the fitted law is none of a flow, such as with a negative rate.
DischargeFit fit_discharge(DischargeLaw law, const DischargeData& data);

/// What the fitted law gives for `point`.
double predicted(const DischargeFit& fit, const DischargeData& data, const DischargePoint& point);

}  // namespace diefill::process::continuum
