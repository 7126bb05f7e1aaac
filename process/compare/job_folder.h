// The runs of a comparison as self-contained folders: a scene file each, with copies of the files it
// needs.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "process/results/studies/job_list.h"
#include "process/scene/variants.h"

namespace diefill::process {

/// Receives messages, one line at a time; nothing: no messages.
using NoteCallback = std::function<void(const std::string&)>;

/// What is to be run, each variant with `seeds` consecutive seeds from its own.
struct WantedJobs {
  std::string title;  ///< of the scene
  std::vector<Variant> variants;
  int seeds = 1;
  /// Names of variants that are run later: their absence here is not reported.
  std::vector<std::string> later;
};

/// The job of a variant's run `k`, counted from 0, with the k-th seed from that of its scene.
results::Job job_of(const Variant& variant, int k);

/// Throws SceneError where a seed would be larger than a scene can state.
void check_seeds(const std::vector<Variant>& variants, int seeds);

/// Writes into `directory`: `<variant>/seed-<k>/scene.toml` for every job; the files that scenes name into
/// `tools/` (copied_files.h); and jobs.json. Jobs are listed seed by seed, so that all variants have their
/// first result early. A folder whose scene asks for another computation now (scene/identity.h), or whose run
/// has begun from other contents of pour.state, is kept as `seed-<k>-previous-<n>`, with its contents; this,
/// and results no longer in the list, is reported. Throws results::ResultError, and
/// SceneError as check_seeds does.
results::JobList write_jobs(const std::filesystem::path& directory, const WantedJobs& wanted,
                            const NoteCallback& on_note);

/// Jobs of a directory that is only read.
struct FoundJobs {
  results::JobList list;               ///< as write_jobs lists them
  std::set<std::string> other_scenes;  ///< folders of jobs that hold a run of another scene
};

/// Makes, writes and renames nothing. Throws results::ResultError for a file of a scene that cannot be read,
/// and SceneError as check_seeds does.
FoundJobs find_jobs(const std::filesystem::path& directory, const WantedJobs& wanted);

/// Writes what runs the jobs elsewhere: jobs.txt, one command line each; run_here.sh, which runs several at a
/// time; and slurm.sh, an array job. Files with other contents are renamed, which is reported. Throws
/// results::ResultError.
void write_job_scripts(const std::filesystem::path& directory, const results::JobList& list,
                       const NoteCallback& on_note);

/// State of a job.
struct JobState {
  enum class Stage { open, finished, failed } stage = Stage::open;
  int exit_code = 0;   ///< of a failed run
  std::string reason;  ///< error message of a failed run
  bool out_of_range() const { return stage == Stage::failed && exit_code == 3; }
};

JobState state_of(const std::filesystem::path& directory, const results::Job& job);

/// Files of a job's folder besides results and checkpoint.
inline constexpr const char* kJobScene = "scene.toml";
inline constexpr const char* kJobLog = "run.log";         ///< messages of the program
inline constexpr const char* kJobExitCode = "exit_code";  ///< exit code of the program

}  // namespace diefill::process
