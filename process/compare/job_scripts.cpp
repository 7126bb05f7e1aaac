#include "process/compare/job_folder.h"
#include "process/results/atomic_file.h"
#include "process/results/result_file.h"

namespace diefill::process {
namespace {

/// One line for a shell in the comparison's directory. It does nothing for a run that is finished; one that
/// was stopped leaves no exit code and stays open.
std::string command_line(const results::Job& job) {
  const std::string folder = job.folder + '/';
  return "[ -e " + folder + "report.json ] && [ ! -e " + folder + "checkpoint.bin ] && exit 0; " +
         "\"${DIEFILL:-diefill}\" run " + folder + kJobScene + " --out " + job.folder +
         " --resume --threads \"${DIEFILL_THREADS:-1}\" >> " + folder + kJobLog + " 2>&1; " +
         "code=$?; [ $code -ge 128 ] || echo $code > " + folder + kJobExitCode + "; exit $code";
}

std::string here_script() {
  return R"sh(#!/bin/sh
# Runs all jobs on this machine, 4 or as many as given at a time; run it again to go on after a stop.
# DIEFILL: the program; DIEFILL_THREADS: threads for each job.
cd "$(dirname "$0")" && xargs -d '\n' -n 1 -P "${1:-4}" sh -c < jobs.txt
)sh";
}

std::string slurm_script(std::size_t jobs) {
  return "#!/bin/sh\n#SBATCH --job-name=diefill\n#SBATCH --array=1-" + std::to_string(jobs) + R"(
#SBATCH --cpus-per-task=4
#SBATCH --output=/dev/null
# Submit from this directory: sbatch slurm.sh. One task runs one line of jobs.txt; submit again to go on.
# DIEFILL: the program. Each job writes run.log in its folder.
export DIEFILL_THREADS="${SLURM_CPUS_PER_TASK:-1}"
cd "${SLURM_SUBMIT_DIR:-.}" && sed -n "${SLURM_ARRAY_TASK_ID}p" jobs.txt | sh
)";
}

void write_script(const std::filesystem::path& file, const std::string& text) {
  results::write_text_atomically(file, text);
  using Permissions = std::filesystem::perms;
  std::filesystem::permissions(file, Permissions::owner_exec | Permissions::group_exec,
                               std::filesystem::perm_options::add);
}

}  // namespace

void write_job_scripts(const std::filesystem::path& directory, const results::JobList& list) {
  std::string lines;
  for (const results::Job& job : list.jobs) lines += command_line(job) + '\n';
  results::write_text_atomically(directory / "jobs.txt", lines);
  write_script(directory / "run_here.sh", here_script());
  write_script(directory / "slurm.sh", slurm_script(list.jobs.size()));
}

}  // namespace diefill::process
