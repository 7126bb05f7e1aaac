// Where the time of threads goes, as figures of a measurement.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::app {

/// Adds to `figures` where the time of `steps` steps went, which took `seconds` (s, wall-clock time) since
/// Simulation::time_loops(): shares of serial work and of waiting, blocks, bytes and seconds of a step.
void add_loop_figures(const engine::Simulation& simulation, double seconds, int steps,
                      nlohmann::ordered_json& figures);

/// Sixteen digits for Simulation::hash().
std::string hash_text(const engine::Simulation& simulation);

}  // namespace diefill::app
