// Round numbers for axes and colour bars: positions of ticks, and how they are written.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace diefill::render {

/// A closed interval of numbers.
struct Interval {
  double lower = 0, upper = 1;
  double length() const { return upper - lower; }
};

/// Ticks of an axis: values in rising order and their labels, one each. An empty label is a minor tick.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;
};

/// The smallest step 1, 2 or 5 times a power of ten that puts at most `most` (>= 2) ticks on `range`.
double nice_step(const Interval& range, int most);

/// Ticks at multiples of nice_step that lie in `range`, all labelled with the same number of decimals.
Ticks nice_ticks(const Interval& range, int most);

/// Ticks for degrees: steps of 15, 30, 45, 60, 90 or 180, as many as fit in `most`; finer ranges get
/// nice_ticks.
Ticks angle_ticks(const Interval& range, int most);

/// `range` widened outwards to multiples of the step that angle_ticks takes.
Interval widen_to_angles(const Interval& range, int most);

/// Ticks for a logarithmic axis (0 < lower < upper): decades labelled, 2 to 9 minor; on less than two decades
/// 2 and 5 are labelled too. Written in full from 0.001 to 50000, else all as powers of ten.
Ticks decade_ticks(const Interval& range);

/// `range` widened outwards to multiples of its nice_step.
Interval widen_to_nice(const Interval& range, int most);

/// A colour scale for `values`: 2nd to 98th percentile of the finite ones, widened to nice numbers and to at
/// least `least_relative_span` of their magnitude, so that numerical noise is not blown up to full contrast.
/// Without finite values 0..1.
Interval robust_range(std::span<const double> values, double least_relative_span = 0.02);

/// `value` written with the decimals that `step` needs and a true minus sign; never "-0". Below 1e-4 and from
/// 1e6 with a power of ten.
std::string tick_label(double value, double step);

}  // namespace diefill::render
