// The method's valid range, monitored while running: a run that leaves it stops with a message, so
// that no wrong results are written.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/numerics/out_of_range.h"

namespace diefill::engine {

class Simulation;

/// Part of the message of a run that ended because its time step is too long; the step follows.
inline constexpr const char* kStepTooLong = "the time step of ";

/// Limits of the method, each found by experiment (STABILITY.md). Between those of the warning and the
/// largest allowed a run continues with a warning in its report.
struct ValidityLimits {
  double warning_overlap = 0.2;  ///< over the smaller sphere radius: Hertz' law is a small-overlap law
  double largest_overlap = 0.6;  ///< over the smaller sphere radius, among grains
  /// Over the sphere radius, with walls. A moving tool may wedge a coarse grain against an edge, where soft
  /// grains slip past with a deep overlap: that is reported. From here on a sphere's centre has passed the
  /// envelope of the wall spheres: it is being pushed through the wall, and may come out behind it.
  double largest_wall_overlap = 1.0;
  double energy_error = 0.05;  ///< of the energy exchanged, gained without any work that explains it
  double warning_energy_error = 0.01;
  /// Displacement of the fastest grain in a step over the sphere radius: two grains that come at each other
  /// so fast are past each other's centres within a few steps.
  double largest_displacement = 0.5;
  /// Step over the critical one of a collision at twice the fastest grain's speed: undamped clumps gain
  /// energy from 0.49 on (STABILITY.md, time step).
  double warning_step = 0.5;
  /// Pairs in touch over spheres. Twelve equal spheres fit round one, which makes 6; fine walls add more.
  double warning_contacts = 8, largest_contacts = 30;
};

/// What a run has been warned of so far, each once: all that a restart needs.
struct ValidityWarnings {
  bool energy = false, speed = false, contacts = false;
  std::vector<std::string> texts;  ///< in the order in which they came
};

/// Of overlaps that a run has had so far, the deepest each; none where they are acceptable.
std::vector<std::string> overlap_warnings(const Simulation& simulation, const ValidityLimits& limits = {});

/// Watches one run.
class ValidityMonitor {
 public:
  explicit ValidityMonitor(const ValidityLimits& limits = {}) : limits_(limits) {}

  /// Checks the simulation as it is now; call every so many steps. Throws OutOfRange past a limit.
  void check(const Simulation& simulation);
  /// Warnings so far, each once; those of overlaps are overlap_warnings().
  const std::vector<std::string>& warnings() const { return state_.texts; }
  const ValidityWarnings& state() const { return state_; }
  /// Continues where another monitor of the run stopped: what it has warned of is not repeated.
  void restore(ValidityWarnings state) { state_ = std::move(state); }

 private:
  void check_numbers(const Simulation& simulation) const;
  void check_overlap(const Simulation& simulation) const;
  void check_time_step(const Simulation& simulation) const;
  void check_energy(const Simulation& simulation);
  void check_speed(const Simulation& simulation);
  void check_contacts(const Simulation& simulation);
  void warn_once(bool& warned, const std::string& warning);

  ValidityLimits limits_;
  ValidityWarnings state_;
};

}  // namespace diefill::engine
