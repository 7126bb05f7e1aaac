#include "process/machine/step.h"

#include <algorithm>

#include "process/machine/smooth_ramp.h"

namespace diefill::process {

double Step::stopping_time(double) const {
  constexpr double kStandStill = 0.02;  // s, as a press takes: 0.2 m/s at 10 m/s^2
  return tools().empty() ? 0 : kStandStill;
}

ToolMotion Step::motion_stopped(double time, double stop) const {
  const double braking = stopping_time(stop);
  if (time <= stop) return motion(time);
  // The step's own clock slows down, so that it comes to rest on its own path.
  const double share = braking > 0 ? std::min((time - stop) / braking, 1.0) : 1;
  const double clock = stop + braking * (share - ramp_integral(share));
  const double whole = duration().value_or(clock);
  ToolMotion slowed = motion(std::min(clock, whole));
  const double rate = clock < whole ? 1 - ramp_value(share) : 0;
  slowed.velocity *= rate;
  slowed.angular_velocity *= rate;
  return slowed;
}

}  // namespace diefill::process
