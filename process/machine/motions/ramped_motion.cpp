#include "process/machine/motions/ramped_motion.h"

#include <algorithm>
#include <limits>

#include "process/input/numbers_apart.h"
#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kRamp = {Dimension::time, "30 ms", "0 s", "100 s", true};
constexpr QuantityRule kDuration = {Dimension::time, "1 s", "0 s", motion_limits::kLongest, true};
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

Envelope RampTimes::envelope(double stop) const {
  return Envelope(ramp, std::min(duration.value_or(kNever), stop + ramp));
}

RampTimes read_ramps(TableReader& table, double ramp) {
  RampTimes ramps;
  ramps.ramp = table.quantity("ramp", kRamp).value_or(ramp);
  ramps.duration = table.quantity("duration", kDuration);
  if (ramps.duration && *ramps.duration < 2 * ramps.ramp)
    table.reject("duration", "its two ramps take " + numbers_apart(2 * ramps.ramp, *ramps.duration).first +
                                 " s; give a longer duration or a shorter ramp");
  return ramps;
}

ToolMotion RampedMotion::motion(double time) const {
  return at(time, ramps_.envelope(kNever));
}

double RampedMotion::stopping_time(double stop) const {
  return ramps_.envelope(stop).end() - stop;
}

ToolMotion RampedMotion::motion_stopped(double time, double stop) const {
  return at(time, ramps_.envelope(stop));
}

}  // namespace diefill::process
