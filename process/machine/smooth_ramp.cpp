#include "process/machine/smooth_ramp.h"

namespace diefill::process {

double Envelope::value(double time) const {
  if (time < 0 || time > end_) return 0;
  if (ramp_ <= 0) return 1;
  return time < end_ - ramp_ ? ramp_value(time / ramp_) : ramp_value((end_ - time) / ramp_);
}

double Envelope::slope(double time) const {
  if (ramp_ <= 0 || time < 0 || time > end_) return 0;
  return time < end_ - ramp_ ? ramp_slope(time / ramp_) / ramp_ : -ramp_slope((end_ - time) / ramp_) / ramp_;
}

double Envelope::integral(double time) const {
  if (time <= 0) return 0;
  if (ramp_ <= 0) return std::min(time, end_);
  if (time <= end_ - ramp_) return ramp_ * ramp_integral(time / ramp_);
  const double left = std::max(end_ - time, 0.0);
  return end_ - ramp_ - ramp_ * ramp_integral(left / ramp_);
}

}  // namespace diefill::process
