#include "process/measure/figures/line_fit.h"

#include <cmath>

#include "process/results/studies/mean.h"

namespace diefill::process {

FittedLine fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2) return {};
  // About the means, so that no digits are lost.
  const double mean_x = results::mean_of(x), mean_y = results::mean_of(y);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
    yy += (y[k] - mean_y) * (y[k] - mean_y);
  }
  if (!(xx > 0)) return {};
  const double slope = xy / xx;
  return {mean_y - slope * mean_x, slope, xy * xy / (xx * yy)};
}

}  // namespace diefill::process
