#include "process/machine/ringing_watch.h"

#include <algorithm>
#include <cstdio>

#include "engine/numerics/out_of_range.h"
#include "process/machine/force_control.h"

namespace diefill::process {

void RingingWatch::add(double share, double now, double longest) {
  if (swings > 0 && now - last > longest) *this = {};
  lowest = swings > 0 ? std::min(lowest, share) : share;
  highest = swings > 0 ? std::max(highest, share) : share;
  // The first oscillation is the one that rises.
  const bool ends = high ? share < kLow : share > kHigh;
  if (!ends) return;
  high = !high;
  last = now;
  ++swings;
}

void watch_for_ringing(RingingWatch& watch, const ForceControl& control, double target, double measured,
                       double now, const std::string& tools) {
  watch.add(measured / target, now, control.integral_time);
  if (!watch.rings()) return;
  char text[400];
  std::snprintf(text, sizeof text,
                "the force control of %s is unstable: the resistance of the powder oscillated %u times in a "
                "row between %.2f and %.2f times the target of %.3g %s by t = %.6g s with nothing else "
                "moving (STABILITY.md, force-controlled pistons); reduce gain (now %.3g)",
                tools.c_str(), static_cast<unsigned>(watch.swings), watch.lowest, watch.highest, target,
                control.turns ? "N m" : "N", now, control.gain);
  throw engine::OutOfRange(text);
}

}  // namespace diefill::process
