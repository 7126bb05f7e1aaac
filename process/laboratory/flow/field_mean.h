// Means of grains' values on the nodes of a slice (Bierwisch 2009, Eq. 2.27), added up over time.
#pragma once

#include <vector>

#include "process/continuum/kinematic_model.h"

namespace diefill::process::laboratory {

/// One quantity on the columns and levels of a hopper's grid.
class FieldMean {
 public:
  /// `averaging_width` is sigma in m. An odd quantity changes its sign in the mirror at x = 0.
  FieldMean(const continuum::HopperGrid& grid, double averaging_width, bool odd);
  /// A grain at x, z (m) and its mirror image have this value. Grains beyond 3 sigma do not count.
  void add(double x, double z, double value);
  /// Means; NaN where the weight of all grains is below a thousandth of the largest.
  std::vector<double> mean() const;

 private:
  void add_one(double x, double z, double value);
  continuum::HopperGrid grid_;
  double width_;
  bool odd_;
  std::vector<double> sum_, weight_;
};

}  // namespace diefill::process::laboratory
