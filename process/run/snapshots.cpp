#include "process/run/snapshots.h"

#include <algorithm>
#include <cstdio>

#include "engine/simulation/simulation.h"

namespace diefill::process {

namespace {

std::string numbered(const std::string& name, std::uint64_t number) {
  char text[24];
  std::snprintf(text, sizeof text, " %04llu", static_cast<unsigned long long>(number));
  return name + text;
}

}  // namespace

std::vector<std::string> Snapshots::due(const Schedule& schedule, const engine::Simulation& simulation) {
  std::vector<std::string> names;
  const double now = simulation.time();
  for (std::size_t k = 0; k < specs_.size(); ++k) {
    const SnapshotSpec& spec = specs_[k];
    SnapshotState& state = states_[k];
    if (state.taken == 0) {
      if (!schedule.holds(spec.when.value_or(Condition{}), state.watch, simulation)) continue;
      state.first = now;
    } else if (!spec.every || now < state.first + static_cast<double>(state.taken) * *spec.every) {
      continue;
    }
    ++state.taken;
    names.push_back(spec.every ? numbered(spec.name, state.taken) : spec.name);
  }
  return names;
}

bool Snapshots::none_due_before(const Stages& stages, const std::vector<StepState>& steps, double now) const {
  return std::none_of(specs_.begin(), specs_.end(), [&](const SnapshotSpec& spec) {
    const auto since = counts_from(spec.when.value_or(Condition{}), stages, steps);
    return since && *since < now;
  });
}

}  // namespace diefill::process
