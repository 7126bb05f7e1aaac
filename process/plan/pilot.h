// A short run of the scene itself, with less and coarser powder, to learn what this machine takes for a
// sphere and a time step in each phase: settling, motion and rest differ by how often neighbours are
// searched.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "process/plan/size_cost.h"
#include "process/plan/timeline.h"

namespace diefill::process::plan {

/// What a pilot run has found of one kind of phase. Seconds of computing are those on free processors: while
/// others have them, they do not count (processor_use.h).
struct PhaseCost {
  double wall_seconds = 0, sphere_steps = 0;
  double seconds = 0;         ///< simulated
  bool whole = false;         ///< the phase was run to its end
  double search_seconds = 0;  ///< of wall_seconds, of searches for near pairs
  double seconds_per_sphere_step() const { return wall_seconds / sphere_steps; }
};

/// A pilot run.
struct Pilot {
  double grain_diameter = 0, fill_height = 0;  ///< m
  double time_step = 0;                        ///< s
  double fall_time = 0;                        ///< s, that its last grain fell (timeline.h)
  std::size_t spheres = 0;
  double wall_seconds = 0;                  ///< s that it took, others' turns included
  double processor_share = 1;               ///< processor time received over that requested
  std::string cached_since;                 ///< date and time of the run, where it was not run now
  std::array<PhaseCost, kPhaseKinds> cost;  ///< by PhaseKind
  RestTimes rest;                           ///< as found, or as usual where it was not seen
  std::string stopped;                      ///< why it ended early; empty: it did not
  SizeCost size;                            ///< measured on the powder as the run left it

  const PhaseCost& of(PhaseKind kind) const { return cost[static_cast<std::size_t>(kind)]; }
  PhaseCost cost_of_all() const;  ///< of all kinds together; never whole
  /// s a sphere and step in a phase of this kind with as many spheres, searching `searches` times as often
  /// and meeting tools `near_tools` times as often; a kind that was not seen costs what settling does.
  double seconds_per_sphere_step(PhaseKind kind, double in_spheres, double searches = 1,
                                 double near_tools = 1) const;
};

/// Runs the scene with as much less and coarser powder (pilot_scene.h) as this machine should manage within
/// `wall_limit` s, determined by a trial of a second, on `threads` threads; up to three times as long where
/// nothing has moved by then or powder still runs out with no cavity to fill; where the scene will take long,
/// for a thirtieth of that, up to eight times the limit. `tooling` is that of the scene.
Pilot run_pilot(const Scene& scene, const Tooling& tooling, int threads, double wall_limit);

}  // namespace diefill::process::plan
