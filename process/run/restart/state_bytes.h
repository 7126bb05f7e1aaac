// States of a simulation, and instants of a result, as bytes of a checkpoint.
#pragma once

#include "engine/simulation/snapshot.h"
#include "process/results/fill_result.h"
#include "process/run/restart/byte_stream.h"

namespace diefill::process {

/// Passes every value to `io`, a ByteWriter or a ByteReader.
template <class Io, class State>
void transfer_simulation(Io& io, State& simulation) {
  io(simulation.step);
  io(simulation.time);
  auto& grains = simulation.grains;
  io(grains.id);
  io(grains.kind);
  io(grains.position);
  io(grains.velocity);
  io(grains.orientation);
  io(grains.spin);
  io(grains.force);
  io(grains.torque);
  io(simulation.reference.position);
  io(simulation.reference.orientation);
  io(simulation.reference.bodies);
  io(simulation.reference.drift);
  io(simulation.reference.group);
  io(simulation.reference.passing);
  io(simulation.reference.time);
  io(simulation.reference.step);
  io(simulation.reference.skin);
  io(simulation.reference.doublings);
  io(simulation.reference.body_allowance);
  io(simulation.reference.awake_grains);
  io(simulation.grain_history.pair);
  io(simulation.grain_history.value);
  io(simulation.wall_history.pair);
  io(simulation.wall_history.value);
  io(simulation.ledger);
  io(simulation.next_id);
  io(simulation.overlap);
  io(simulation.sleep.asleep);
  io(simulation.sleep.checks);
  io(simulation.sleep.force);
  io(simulation.sleep.place);
  io(simulation.sleep.sphere_steps_left_out);
}

/// The same of instants.
template <class Io, class Instants>
void transfer_instants(Io& io, Instants& instants) {
  std::uint64_t count = instants.size();
  io(count);
  if constexpr (!std::is_const_v<Instants>) instants.resize(count);
  for (auto& instant : instants) {
    io(instant.time);
    io(instant.id);
    io(instant.kind);
    io(instant.position);
    io(instant.orientation);
    io(instant.velocity);
    io(instant.tool_orientation);
    io(instant.tool_displacement);
  }
}

}  // namespace diefill::process
