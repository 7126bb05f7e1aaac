// Starts that runs share: variants that differ only in later steps need not pour and fill again. At the end
// of every stage a run stores its checkpoint for others; a new run continues from the latest one in which
// everything that has acted is its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "process/run/restart/checkpoint.h"
#include "process/scene/identity.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// What else determines a run besides its scene and the shape of its walls.
struct RunFrame {
  double time_step = 0;                ///< s
  geometry::Box domain;                ///< m, grains beyond it leave the computation
  std::vector<InputFile> inputs = {};  ///< that the scene refers to, as they were when they were read
};

/// Hash of all that has acted on a run up to `now` (s): the scene without its title, limits and intervals of
/// computing (scene/identity.h), snapshots and the effects of steps that have not begun, or begin now without
/// having touched the powder; the files that powder begins with; walls as they are covered; time step and
/// domain. Runs of equal hash are in the same state, bit for bit.
std::uint64_t start_hash(const Scene& scene, const Tooling& tooling, const RunFrame& frame,
                         const ScheduleState& schedule, double now);

/// The schedule of a run of other steps as one of `count` stages has it; nothing where a stage that it has
/// not got has begun.
std::optional<ScheduleState> with_steps(ScheduleState schedule, std::size_t count);

/// Stores the checkpoint in `directory` for others, unless one of the same start is there. Throws
/// results::ResultError when the disk is full.
void save_shared_start(const std::filesystem::path& directory, const Checkpoint& checkpoint);

/// The latest checkpoint in `directory` that `is_own` accepts; files that cannot be read are skipped, because
/// they only cost time. Nothing where there is none.
std::optional<Checkpoint> latest_shared_start(const std::filesystem::path& directory,
                                              const std::function<bool(const Checkpoint&)>& is_own);

}  // namespace diefill::process
