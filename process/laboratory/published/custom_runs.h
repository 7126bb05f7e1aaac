// Makes the custom runs of an experiment, several at a time, and stores each in `<run>/seed-<k>/` of the
// experiment's folder: result.json, whole or not at all, once it is done; until then checkpoint.bin. A run is
// repeated where its settings differ from those stored.
#pragma once

#include <stdexcept>
#include <vector>

#include "process/laboratory/published/perform.h"

namespace diefill::process::laboratory {

/// A run has been stopped; its checkpoint is kept.
struct CustomRunStopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// s between two checkpoints.
inline constexpr double kCustomRunCheckpoint = 60;

/// Makes every run that is not finished, with `jobs.seeds` seeds from 1 on, one core each, within the budget
/// in processor time that all have together, earlier calls included. Throws Interrupted when asked to stop,
/// results::ResultError where results cannot be written.
void make_custom_runs(const std::vector<CustomRun>& runs, const LabJobs& jobs);

/// A run as it is stored.
struct StoredCustomRun {
  bool finished = false;
  std::string result;       ///< of a finished one
  std::string failure;      ///< why it failed; empty: it did not
  double core_seconds = 0;  ///< s of processor time so far
};

StoredCustomRun stored_custom_run(const std::filesystem::path& directory, const CustomRun& run,
                                  std::uint64_t seed);

}  // namespace diefill::process::laboratory
