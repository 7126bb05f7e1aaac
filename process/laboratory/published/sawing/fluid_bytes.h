// A fluid's state as bytes of a checkpoint.
#pragma once

#include "engine/fluid/fluid_simulation.h"
#include "process/run/restart/state_bytes.h"

namespace diefill::process::laboratory::sawing {

/// Passes every value to `io`, a ByteWriter or a ByteReader.
template <class Io, class State>
void transfer_fluid(Io& io, State& fluid) {
  transfer_simulation(io, fluid.particles);
  io(fluid.solids);
}

}  // namespace diefill::process::laboratory::sawing
