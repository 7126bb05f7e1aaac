// Stops and continues runs: a checkpoint file holds all that a run needs to continue bit for bit, and is
// written completely or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/limits/validity_monitor.h"
#include "engine/simulation/snapshot.h"
#include "process/results/fill_result.h"
#include "process/run/free_tools.h"
#include "process/run/leak_watch.h"
#include "process/run/probes.h"
#include "process/run/schedule.h"
#include "process/run/snapshots.h"
#include "process/run/standstill.h"
#include "process/run/stray_watch.h"

namespace diefill::process {

/// A run at one instant. `scene_hash` ties it to its scene and CAD files, `start_hash` to all that has acted
/// so far (shared_start.h).
struct Checkpoint {
  std::uint64_t scene_hash = 0, start_hash = 0;
  engine::Snapshot simulation;
  ScheduleState schedule;
  ProbesState probes;
  FreeToolsState free_tools;
  std::vector<SnapshotState> snapshots;
  /// Grains of each type out of the computation: spilled or discharged, and wedged between tools.
  std::vector<std::uint64_t> grains_removed, grains_sheared;
  LeakState leaks;                         ///< of grains that left beneath the cavity
  StrayState strays;                       ///< grains that came into tools where no walls are
  Standstill standstill;                   ///< powder at rest while the scene waits
  engine::ValidityWarnings warnings;       ///< of the method's limits, so far
  double wall_seconds = 0;                 ///< s of computing so far, over all sittings
  std::uint64_t sphere_steps = 0;          ///< spheres times steps so far
  std::vector<results::Instant> instants;  ///< kept so far; tools' poses in the laboratory frame
};

/// The file of a run's checkpoint in its results directory.
std::filesystem::path checkpoint_file(const std::filesystem::path& directory);

/// Writes the checkpoint to a file. Throws results::ResultError when the disk is full; the previous one then
/// stays.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Reads such a file; nothing if there is none. Throws results::ResultError when it is damaged or of another
/// program version.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path);

}  // namespace diefill::process
