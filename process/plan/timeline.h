// How long each part of a scene takes, as far as that is known before it runs.
#pragma once

#include <optional>
#include <vector>

#include "process/tooling/stages.h"

namespace diefill::process::plan {

/// What goes on: poured powder falls and comes to rest; tools move or powder comes in; nothing moves.
enum class PhaseKind { fall, motion, rest };
inline constexpr int kPhaseKinds = 3;

/// "settling of the poured powder", "motion", "rest".
const char* description(PhaseKind kind);

/// A stretch of a scene.
struct Phase {
  PhaseKind kind = PhaseKind::rest;
  double seconds = 0;  ///< simulated
  double share = 1;    ///< grains there on average, over those poured
};

/// How long powder goes on moving after it has fallen, and after tools have stopped, until it counts as at
/// rest (process/tooling/rest). Measured on sample scenes with grains of 1.88 mm: after the fall 0.101 s
/// (narrow_ring/fill.toml), after a passage 0.159 s; the rule itself takes 0.1 s unless all is quiet sooner.
struct RestTimes {
  double after_fall = 0.101, after_motion = 0.159;  ///< s
};

/// s that the last grain falls from the lattice onto the powder: sqrt(2 h / g) over the lattice's height less
/// the settled powder's.
double fall_time(const Scene& scene, const Tooling& tooling);

/// The kind of a moment when the steps with `states` are on.
PhaseKind kind_of(const Stages& stages, const std::vector<StepState>& states);

/// The scene's phases in their order. Steps must have been prepared.
std::vector<Phase> timeline(const Scene& scene, const Tooling& tooling, const RestTimes& rest);

}  // namespace diefill::process::plan
