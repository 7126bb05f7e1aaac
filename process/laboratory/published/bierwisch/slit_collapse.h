// Whether discharge through slits depends only on the slit's width less 1.4 grain sizes (Bierwisch 2009,
// section 3.2.2, Fig. 3.5).
#pragma once

#include <limits>
#include <vector>

namespace diefill::process::laboratory {

/// Discharge of several grain sizes through several slits.
struct SlitPoints {
  std::vector<double> rate;             ///< m^2/s, solid volume over time and slice depth
  std::vector<double> width, diameter;  ///< m
};

/// c of rate = a (D - c d)^(3/2), by least squares of rate^(2/3), which is linear in D and d; and its
/// standard error by propagation. NaN for fewer than four points, or where one has no rate.
struct SlitOffset {
  double value = std::numeric_limits<double>::quiet_NaN(), error = value;
};
SlitOffset fitted_offset(const SlitPoints& points);

/// Standard deviation of the rates about the power of D - 1.4 d that fits all points best, over that power;
/// its exponent is free. NaN as above, or where a slit is no wider than 1.4 d.
double spread_about_one_curve(const SlitPoints& points);

/// At most 1 where sizes collapse: the larger of the offset's difference from 1.4 over 0.3, and of the spread
/// over 5 %.
double lack_of_slit_collapse(const SlitPoints& points);

}  // namespace diefill::process::laboratory
