#include "process/results/instant_powder.h"

namespace diefill::results {

PowderState powder_at(const PowderState& end, const Instant& instant) {
  PowderState powder = end;
  powder.time = instant.time;
  powder.id = instant.id;
  powder.kind = instant.kind;
  powder.position = instant.position;
  powder.orientation = instant.orientation;
  powder.velocity = instant.velocity;
  powder.angular_velocity.clear();
  return powder;
}

}  // namespace diefill::results
