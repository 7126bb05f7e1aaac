// What a step moves through memory.
#pragma once

namespace diefill::engine {

class Simulation;

/// Bytes that one step reads and writes at least: state of grains and spheres, near pairs and contact
/// history, each counted once a pass.
double bytes_moved_per_step(const Simulation& simulation);

}  // namespace diefill::engine
