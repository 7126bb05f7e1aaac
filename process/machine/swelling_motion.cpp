#include "process/machine/swelling_motion.h"

#include <algorithm>
#include <limits>

#include "process/input/numbers_apart.h"
#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kRamp = {Dimension::time, "30 ms", "0 s", "100 s", true};
constexpr QuantityRule kDuration = {Dimension::time, "1 s", "0 s", "1000 s", true};
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

Envelope Swelling::envelope(double stop) const {
  return Envelope(ramp, std::min(duration.value_or(kNever), stop + ramp));
}

Swelling read_swelling(TableReader& table, double ramp) {
  Swelling swelling;
  swelling.ramp = table.quantity("ramp", kRamp).value_or(ramp);
  swelling.duration = table.quantity("duration", kDuration);
  if (swelling.duration && *swelling.duration < 2 * swelling.ramp)
    table.reject("duration", "its two ramps take " +
                                 numbers_apart(2 * swelling.ramp, *swelling.duration).first +
                                 " s; give a longer duration or a shorter ramp");
  return swelling;
}

ToolMotion SwellingMotion::motion(double time) const {
  return at(time, swelling_.envelope(kNever));
}

double SwellingMotion::stopping_time(double stop) const {
  return swelling_.envelope(stop).end() - stop;
}

ToolMotion SwellingMotion::motion_stopped(double time, double stop) const {
  return at(time, swelling_.envelope(stop));
}

}  // namespace diefill::process
