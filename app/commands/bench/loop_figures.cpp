#include "app/commands/bench/loop_figures.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/observe/memory_traffic.h"
#include "engine/simulation/simulation.h"
#include "process/results/storage/hash_text.h"

namespace diefill::app {

void add_loop_figures(const engine::Simulation& simulation, double seconds, int steps,
                      nlohmann::ordered_json& figures) {
  const engine::LoopTimes times = simulation.loop_times();
  const double threads = simulation.settings().threads;
  const double busy = std::accumulate(times.busy.begin(), times.busy.end(), 0.0);
  const bool shared = threads > 1;
  figures["serial_share"] = shared ? 1 - times.loops / seconds : 1;
  figures["waiting_share"] = shared ? times.loops / seconds - busy / (threads * seconds) : 0;
  figures["blocks"] = simulation.neighbours().blocks().size();
  figures["bytes_per_step"] = engine::bytes_moved_per_step(simulation);
  figures["seconds_per_step"] = seconds / steps;
}

std::string hash_text(const engine::Simulation& simulation) {
  return results::hash_text(simulation.hash());
}

}  // namespace diefill::app
