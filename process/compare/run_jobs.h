// Runs the jobs of a comparison on this machine, several at a time, each as a process of its own, so that a
// crash affects only one.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "process/results/studies/job_list.h"

namespace diefill::process {

/// A run of a list while the list is being processed.
struct JobProgress {
  const results::Job* job = nullptr;
  std::string state;   ///< "waiting", "running", "finished", or why it failed
  double share = 0;    ///< of its work that is done, 0 to 1
  double seconds = 0;  ///< of wall time so far, of this attempt; 0: unknown
};

/// All runs of a list, in its order.
struct JobListProgress {
  std::vector<JobProgress> jobs;
  double share = 0;        ///< of the work that is done, 0 to 1
  double seconds = 0;      ///< since the call
  double first_share = 0;  ///< of the work that earlier calls had done
};

struct JobOptions {
  std::filesystem::path program;  ///< diefill itself
  int at_once = 1;                ///< jobs at a time
  int cores = 1;                  ///< shared evenly by them, at least one thread each
  int threads = 0;                ///< of each job; 0: cores / at_once
  bool pictures = true;           ///< whether jobs draw their results
  /// Whether jobs use each other's shared starts (run/restart/shared_start.h). Results are the same; the cost
  /// of a job is not.
  bool share_starts = false;
  /// s of processor time that all jobs together may have cost, earlier runs of them included. Running jobs
  /// are then stopped with a checkpoint, waiting ones are not started.
  double cpu_seconds = std::numeric_limits<double>::infinity();
  /// Whether a job is to start, given what is left of `cpu_seconds`. Empty: always.
  std::function<bool(const results::Job&, double left)> starts;
  bool show_progress = true;
  /// How the user continues after a stop: the end of its message.
  std::string to_continue = "run the same command again to continue";
  const std::atomic<bool>* stop = nullptr;  ///< set from a signal handler
  /// Called every few seconds, and at the end, with the progress of the runs. May be empty.
  std::function<void(const JobListProgress&)> watch;
};

/// Runs every job that is not finished, from its checkpoint where it has one; one that left the method's
/// valid range before would do so again and is left out. The output of a job goes to its run.log, its exit
/// code to its exit_code. When asked to stop it stops the jobs with a checkpoint and throws Interrupted.
/// Throws std::runtime_error where no process can be made. What a job costs goes to its folder
/// (results/studies/job_cost.h).
void run_jobs(const std::filesystem::path& directory, const results::JobList& list,
              const JobOptions& options);

}  // namespace diefill::process
