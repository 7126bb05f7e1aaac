#include "process/machine/motions/straight_move.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::process {

StraightMove::StraightMove(double distance, double velocity, double acceleration)
    : distance_(distance), acceleration_(acceleration) {
  if (!(distance > 0) || !(velocity > 0) || !(acceleration > 0)) {
    throw std::invalid_argument("a straight move needs a positive distance, velocity and acceleration");
  }
  peak_velocity_ = std::min(velocity, std::sqrt(acceleration * distance));
  ramp_time_ = peak_velocity_ / acceleration;
  duration_ = distance / peak_velocity_ + ramp_time_;
}

double StraightMove::position(double time) const {
  if (time <= 0) return 0;
  if (time >= duration_) return distance_;
  // The second half is the first one run backwards.
  if (time > duration_ / 2) return distance_ - position(duration_ - time);
  if (time <= ramp_time_) return acceleration_ * time * time / 2;
  return peak_velocity_ * (time - ramp_time_ / 2);
}

double StraightMove::velocity(double time) const {
  if (time <= 0 || time >= duration_) return 0;
  return std::min({acceleration_ * time, peak_velocity_, acceleration_ * (duration_ - time)});
}

}  // namespace diefill::process
