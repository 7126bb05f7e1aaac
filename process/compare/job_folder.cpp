#include "process/compare/job_folder.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "process/compare/backups.h"
#include "process/compare/copied_files.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"
#include "process/results/word_list.h"
#include "process/run/restart/checkpoint.h"
#include "process/run/restart/input_record.h"
#include "process/scene/identity.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxListed = 6;  // folders in a note

/// Empty where there is no such file.
std::string text_in(const fs::path& file) {
  return results::contents_or_nothing(file).value_or("");
}

/// The scene's text with copied files named by the hash in their names alone, not by how they were called.
std::string with_hashes(std::string text) {
  constexpr std::size_t kDigits = 16;
  const std::string start = "../../tools/";
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at)) {
    at += start.size();
    const std::size_t end = std::min(text.size(), text.find_first_of("'\"/\n", at));
    const std::size_t dash = text.rfind('-', end - 1);
    if (dash == std::string::npos || dash < at || dash + kDigits >= end) continue;
    if (text.find_first_not_of("0123456789abcdef", dash + 1) >= dash + 1 + kDigits) text.erase(at, dash - at);
  }
  return text;
}

/// Whether two scenes of a job's folder ask for the same computation.
bool same_computation(const std::string& a, const std::string& b, const fs::path& file) {
  try {
    return scene_identity(with_hashes(a), file, {}) == scene_identity(with_hashes(b), file, {});
  } catch (const SceneError&) {
    return false;
  }
}

/// What a job is to compute.
struct JobScene {
  std::string text;
  bool begins_from_state = false;  ///< pour.state
};

JobScene job_scene(const Scene& scene, std::uint64_t seed,
                   const std::function<std::string(const fs::path&)>& elsewhere) {
  return {scene_text_with(scene, seed, elsewhere), scene.pour.state.has_value()};
}

/// Whether the run in the folder has begun from other contents of pour.state, which is named by its path,
/// while copied files are named by their contents.
bool began_from_another_state(const fs::path& folder, const JobScene& wanted) {
  if (!wanted.begins_from_state) return false;
  const auto then = input_files_read_in(folder);
  return then && changed_file(input_files(wanted.text, folder / kJobScene), *then);
}

/// Whether the folder's scene asks for another computation, or its run has made another.
bool holds_another(const fs::path& folder, const std::string& before, const JobScene& wanted) {
  return (before != wanted.text && !same_computation(before, wanted.text, folder / kJobScene)) ||
         began_from_another_state(folder, wanted);
}

/// Makes the job's scene file. Where the folder holds another computation, it is renamed, and its new path
/// given.
std::optional<fs::path> write_scene(const fs::path& folder, const JobScene& wanted) {
  const fs::path scene = folder / kJobScene;
  const std::string before = text_in(scene);
  const bool another = fs::exists(folder) && holds_another(folder, before, wanted);
  if (before == wanted.text && !another) return std::nullopt;
  std::optional<fs::path> renamed;
  if (another) {
    if (!fs::is_empty(folder)) renamed = back_up(folder);
  } else if (fs::exists(folder)) {
    // The limits of its computation may have changed: a failed run is tried again.
    const fs::path code = folder / kJobExitCode;
    if (text_in(code) != "0\n") fs::remove(code);
  }
  make_folder(folder);
  results::write_text_atomically(scene, wanted.text);
  return renamed;
}

/// The list that lies there. One that cannot be read is renamed.
results::JobList earlier_list(const fs::path& directory, const NoteCallback& on_note) {
  if (!fs::exists(results::job_list_file(directory))) return {};
  try {
    return results::read_job_list(directory);
  } catch (const results::ResultError& error) {
    const fs::path renamed = back_up(results::job_list_file(directory));
    if (on_note)
      on_note("note: " + std::string(error.what()) + "; it was renamed to " + renamed.filename().string());
    return {};
  }
}

/// Whether the folder holds anything computed.
bool holds_work(const fs::path& folder) {
  for (const char* name : {"report.json", "results.h5", "checkpoint.bin"})
    if (fs::exists(folder / name)) return true;
  return false;
}

/// Folders with results that the earlier list names and the new one does not.
std::vector<std::string> left_out(const fs::path& directory, const results::JobList& earlier,
                                  const results::JobList& now, const std::vector<std::string>& later) {
  std::vector<std::string> folders;
  for (const results::Job& job : earlier.jobs) {
    const auto same = [&](const results::Job& other) { return other.folder == job.folder; };
    if (std::any_of(now.jobs.begin(), now.jobs.end(), same)) continue;
    if (std::find(later.begin(), later.end(), job.variant) != later.end()) continue;
    if (holds_work(directory / job.folder)) folders.push_back(job.folder);
  }
  return folders;
}

using DoWithJob = std::function<void(const std::string& folder, const Scene&, std::uint64_t seed)>;

/// The jobs, seed by seed; `act` is called for each.
results::JobList jobs_of(const WantedJobs& wanted, const DoWithJob& act) {
  results::JobList list;
  list.title = wanted.title;
  for (const Variant& variant : wanted.variants) list.variants.push_back(variant.name);
  for (int k = 0; k < wanted.seeds; ++k)
    for (const Variant& variant : wanted.variants) {
      list.jobs.push_back(job_of(variant, k));
      act(list.jobs.back().folder, variant.scene, list.jobs.back().seed);
    }
  return list;
}

/// What the run said last, without the program's name.
std::string last_message(const fs::path& log) {
  const std::string start = "diefill: ";
  std::istringstream lines(text_in(log));
  std::string message;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(start)) message = line.substr(start.size());
  return message;
}

/// Number in the file, or -1.
int exit_code_in(const fs::path& file) {
  std::ifstream stream(file);
  int code = -1;
  stream >> code;
  return stream ? code : -1;
}

}  // namespace

results::Job job_of(const Variant& variant, int k) {
  const std::uint64_t seed = variant.scene.seed + static_cast<std::uint64_t>(k);
  return {variant.name, seed, results::job_folder(variant.folder, seed)};
}

void check_seeds(const std::vector<Variant>& variants, int seeds) {
  constexpr std::uint64_t kLargest = INT64_MAX;  // that TOML knows
  const auto more = static_cast<std::uint64_t>(seeds - 1);
  for (const Variant& variant : variants)
    if (variant.scene.seed > kLargest - more)
      throw SceneError(variant.scene.file.string() + ": seed: found " + std::to_string(variant.scene.seed) +
                       ", and " + std::to_string(seeds) + " consecutive seeds exceed " +
                       std::to_string(kLargest) + ", the largest seed; give one from 0 to " +
                       std::to_string(kLargest - more));
}

results::JobList write_jobs(const fs::path& directory, const WantedJobs& wanted,
                            const NoteCallback& on_note) {
  check_seeds(wanted.variants, wanted.seeds);
  const results::JobList earlier = earlier_list(directory, on_note);
  CopiedFiles copies(directory);
  const auto elsewhere = [&](const fs::path& file) { return "../../" + copies.copy(file); };
  std::vector<std::string> renamed;
  const auto list = jobs_of(wanted, [&](const std::string& folder, const Scene& scene, std::uint64_t seed) {
    if (const auto kept = write_scene(directory / folder, job_scene(scene, seed, elsewhere)))
      renamed.push_back(folder + " as " + kept->filename().string());
  });
  const auto missing = left_out(directory, earlier, list, wanted.later);
  if (on_note && !renamed.empty())
    on_note("note: in " + directory.string() +
            ", runs of a different scene or from another pour.state were renamed: " +
            results::comma_list(renamed, kMaxListed));
  if (on_note && !missing.empty())
    on_note("note: in " + directory.string() +
            ", earlier runs are no longer in the list and were left in place: " +
            results::comma_list(missing, kMaxListed));
  results::write_job_list(directory, list);
  return list;
}

FoundJobs find_jobs(const fs::path& directory, const WantedJobs& wanted) {
  check_seeds(wanted.variants, wanted.seeds);
  const auto elsewhere = [](const fs::path& file) { return "../../" + path_of_copy(file); };
  FoundJobs found;
  found.list = jobs_of(wanted, [&](const std::string& folder, const Scene& scene, std::uint64_t seed) {
    const fs::path file = directory / folder / kJobScene;
    if (!fs::exists(file)) return;
    if (holds_another(directory / folder, text_in(file), job_scene(scene, seed, elsewhere)))
      found.other_scenes.insert(folder);
  });
  return found;
}

JobState state_of(const fs::path& directory, const results::Job& job) {
  const fs::path folder = directory / job.folder;
  JobState state;
  const int code = exit_code_in(folder / kJobExitCode);
  const bool complete = fs::exists(folder / "report.json") && fs::exists(folder / "results.h5") &&
                        !fs::exists(checkpoint_file(folder));
  if (complete && code <= 0) {
    state.stage = JobState::Stage::finished;
  } else if (code > 0) {
    state.stage = JobState::Stage::failed;
    state.exit_code = code;
    state.reason = last_message(folder / kJobLog);
    if (state.reason.empty())
      state.reason = "ended with exit code " + std::to_string(code) + " without a message";
  }
  return state;
}

}  // namespace diefill::process
