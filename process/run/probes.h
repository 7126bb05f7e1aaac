// Records the probes of a scene during a run: loads on tools, mass through planes, filled mass, fill level,
// energy. A scene without probes has no cost.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "process/results/fill_result.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// State of a probe; all that a restart needs besides its rows.
struct ProbeState {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();  ///< summed over steps
  std::uint64_t steps = 0;                                                            ///< since the last row
  std::uint64_t numbers = 0;                                                          ///< in all rows
  double beyond = 0;  ///< kg that lay beyond the plane at first, and came in beyond it
  /// kg taken out of the computation beyond the plane, or moved from there by a periodic border.
  double gone = 0;
};

/// All probes' states, and their rows one probe after the other.
struct ProbesState {
  std::vector<ProbeState> probes;
  std::vector<double> rows;
};

class Probes {
 public:
  /// Keeps references to both.
  Probes(const Scene& scene, const Tooling& tooling);

  bool any() const { return !specs_.empty(); }
  /// Records the state before the first step.
  void begin(const engine::Simulation& simulation);
  /// To be called after every time step; adds a row where an interval is over.
  void observe(const engine::Simulation& simulation);
  /// The first step after `step` with a row that needs the grains; a very large number where there is none.
  std::uint64_t next_sync_step(std::uint64_t step, double time_step) const;
  /// Whether one of the rows of `step` needs contacts.
  bool needs_contacts(std::uint64_t step, double time_step) const;
  /// kg of grains that are taken out at `position`, or come in (`sign` -1).
  void count_removed(const Eigen::Vector3d& position, double mass, double sign);
  /// kg of a grain that was put back into the periodic box, from `before` to `now` (m): it has passed no
  /// plane.
  void count_wrapped(const Eigen::Vector3d& before, const Eigen::Vector3d& now, double mass);

  ProbesState state() const;
  void restore(const ProbesState& state);
  std::vector<results::ProbeSeries> series() const;

 private:
  void add_row(std::size_t k, const engine::Simulation& simulation);
  std::vector<double> fill_level(const engine::Simulation& simulation) const;

  const Scene& scene_;
  const Tooling& tooling_;
  const std::vector<ProbeSpec>& specs_;
  std::vector<ProbeState> states_;
  std::vector<std::vector<double>> rows_;  ///< row after row
};

}  // namespace diefill::process
