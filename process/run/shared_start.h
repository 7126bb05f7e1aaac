// Beginnings that runs have in common: variants that differ only in what they do later need not pour and fill
// again. At the end of every stage a run leaves its checkpoint for others; one that begins goes on from the
// latest in which everything that has acted is its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "process/run/checkpoint.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// What else decides a run besides its scene and the shape of its walls.
struct RunFrame {
  double time_step = 0;  ///< s
  geometry::Box domain;  ///< m, grains beyond it leave the computation
};

/// Hash of all that has acted on a run up to `now` (s): the scene but for its title, its limits and
/// intervals of computing (scene/identity.h), its snapshots and for what steps do that have not begun, or
/// begin at this very instant without having touched the powder; walls as they are laid; time step and
/// domain. Runs of one hash are in the same state, bit for bit.
std::uint64_t start_hash(const Scene& scene, const Tooling& tooling, const RunFrame& frame,
                         const ScheduleState& schedule, double now);

/// The schedule of a run of other steps as one of `count` stages has it; nothing where a stage that it has
/// not got has begun.
std::optional<ScheduleState> with_steps(ScheduleState schedule, std::size_t count);

/// Leaves the checkpoint in `directory` for others, unless one of the same beginning lies there. Throws
/// results::ResultError when the disk is full.
void save_shared_start(const std::filesystem::path& directory, const Checkpoint& checkpoint);

/// The latest in `directory` that `is_own` knows as a beginning of its own; files that cannot be read are
/// passed over, for they only cost time. Nothing where there is none.
std::optional<Checkpoint> latest_shared_start(const std::filesystem::path& directory,
                                              const std::function<bool(const Checkpoint&)>& is_own);

}  // namespace diefill::process
