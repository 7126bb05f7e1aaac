#include "render/report/critical_speed.h"

#include <cmath>
#include <limits>

namespace diefill::render::report {

CriticalSpeed critical_speed(const std::vector<double>& speed, const std::vector<double>& fill_ratio,
                             double complete) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CriticalSpeed result{none, none, 0};
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t n = 0; n < speed.size(); ++n) {
    if (!(speed[n] > 0) || !(fill_ratio[n] > 0) || !(fill_ratio[n] < complete)) continue;
    const double u = std::log(speed[n]), w = std::log(fill_ratio[n]);
    x += u;
    y += w;
    xx += u * u;
    xy += u * w;
    ++result.points;
  }
  const double count = result.points, spread = count * xx - x * x;
  if (result.points < 2 || !(spread > 1e-12 * count * xx)) return result;
  const double slope = (count * xy - x * y) / spread;
  if (!(slope < 0)) return result;
  result.exponent = -slope;
  result.speed = std::exp((y - slope * x) / (count * result.exponent));
  return result;
}

}  // namespace diefill::render::report
