#include <optional>

#include "process/compare/backups.h"
#include "process/compare/job_folder.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

/// One line for a shell in the comparison's directory. It does nothing for a run that is finished; one that
/// was stopped leaves no exit code and stays open. Folders' names need no quotes (scene/folder_names.h).
std::string command_line(const results::Job& job) {
  const std::string folder = job.folder + '/', code = folder + kJobExitCode;
  return "[ -e " + folder + "report.json ] && [ ! -e " + folder + "checkpoint.bin ] && [ \"$(cat " + code +
         " 2>/dev/null || echo 0)\" = 0 ] && exit 0; rm -f " + code + "; \"${DIEFILL:-diefill}\" run " +
         folder + kJobScene + " --out " + job.folder + " --resume --threads \"${DIEFILL_THREADS:-1}\" >> " +
         folder + kJobLog + " 2>&1; code=$?; [ $code -ge 128 ] || echo $code > " + code + "; exit $code";
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
# Submit from this directory: sbatch slurm.sh. One task runs one line of jobs.txt; submit again to continue.
# DIEFILL: the program. Each job writes run.log in its folder.
export DIEFILL_THREADS="${SLURM_CPUS_PER_TASK:-1}"
cd "${SLURM_SUBMIT_DIR:-.}" && sed -n "${SLURM_ARRAY_TASK_ID}p" jobs.txt | sh
)";
}

/// Writes the file. An existing one with other contents, which the user may have edited, is renamed; gives
/// its new name.
std::optional<std::string> write_file(const fs::path& file, const std::string& text, bool runs) {
  if (results::contents_or_nothing(file).value_or("") == text) return std::nullopt;
  std::optional<std::string> renamed;
  if (fs::exists(file)) renamed = file.filename().string() + " as " + back_up(file).filename().string();
  results::write_text_atomically(file, text);
  using Permissions = fs::perms;
  if (runs) fs::permissions(file, Permissions::owner_exec | Permissions::group_exec, fs::perm_options::add);
  return renamed;
}

}  // namespace

void write_job_scripts(const fs::path& directory, const results::JobList& list, const NoteCallback& on_note) {
  std::string lines, kept;
  for (const results::Job& job : list.jobs) lines += command_line(job) + '\n';
  for (const auto& renamed : {write_file(directory / "jobs.txt", lines, false),
                              write_file(directory / "run_here.sh", here_script(), true),
                              write_file(directory / "slurm.sh", slurm_script(list.jobs.size()), true)})
    if (renamed) kept += (kept.empty() ? "" : ", ") + *renamed;
  if (on_note && !kept.empty())
    on_note("note: in " + directory.string() + ", earlier job scripts were renamed: " + kept);
}

}  // namespace diefill::process
