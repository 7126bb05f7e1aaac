// The runs of a comparison as folders that stand alone: a scene file each, CAD files copied beside them.
#pragma once

#include <filesystem>
#include <vector>

#include "process/results/job_list.h"
#include "process/scene/variants.h"

namespace diefill::process {

/// Writes into `directory`: `<variant>/seed-<k>/scene.toml` for `seeds` seeds of each variant, counted up
/// from the variant's own; the CAD files into `tools/`, named after their contents; and jobs.json. Jobs are
/// listed seed by seed, so that all variants have their first result early. A folder whose scene or CAD has
/// changed loses its results and checkpoint; all others keep them. Throws results::ResultError.
results::JobList write_jobs(const std::filesystem::path& directory, const std::string& title,
                            const std::vector<Variant>& variants, int seeds);

/// Writes what runs the jobs elsewhere: jobs.txt, one command line each; run_here.sh, which runs several at a
/// time; and slurm.sh, an array job. Throws results::ResultError.
void write_job_scripts(const std::filesystem::path& directory, const results::JobList& list);

/// How far a job has come.
struct JobState {
  enum class Stage { open, finished, failed } stage = Stage::open;
  int exit_code = 0;   ///< of a failed run
  std::string reason;  ///< what a failed run said
  bool out_of_range() const { return stage == Stage::failed && exit_code == 3; }
};

JobState state_of(const std::filesystem::path& directory, const results::Job& job);

/// Files of a job's folder besides results and checkpoint.
inline constexpr const char* kJobScene = "scene.toml";
inline constexpr const char* kJobLog = "run.log";         ///< what the program said
inline constexpr const char* kJobExitCode = "exit_code";  ///< how it ended

}  // namespace diefill::process
