#include "process/laboratory/published/bierwisch/discharge_residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/laboratory/published/bierwisch/slit_scene.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kSlowest = 0.1, kFastest = 0.8;          // m/s, of the fitted range
constexpr double kShareWithin = 0.1, kAreaWithin = 2e-6;  // of the measured area; m^2

}  // namespace

double discharge_residual(const std::vector<PassagePoint>& points, double width) {
  constexpr int kSamples = 4000;
  const double largest = measured_area(width, kSlowest);  // the curve falls with the speed
  double sum = 0;
  for (const PassagePoint& point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kSamples; ++k) {
      const double speed = kSlowest + (kFastest - kSlowest) * k / kSamples;
      nearest = std::min(nearest, std::pow((point.speed - speed) / kFastest, 2) +
                                      std::pow((point.area - measured_area(width, speed)) / largest, 2));
    }
    sum += nearest;
  }
  return sum / static_cast<double>(points.size());
}

double largest_deviation(const std::vector<PassagePoint>& points, double width) {
  double largest = 0;
  for (const PassagePoint& point : points) {
    const double measured = measured_area(width, point.speed);
    largest =
        std::max(largest, std::abs(point.area - measured) / std::max(kShareWithin * measured, kAreaWithin));
  }
  return largest;
}

}  // namespace diefill::process::laboratory
