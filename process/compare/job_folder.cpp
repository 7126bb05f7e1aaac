#include "process/compare/job_folder.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include "geometry/mesh_import.h"
#include "process/results/atomic_file.h"
#include "process/results/job_cost.h"
#include "process/results/result_file.h"
#include "process/run/checkpoint.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

constexpr const char* kToolFolder = "tools";

std::string contents_or_nothing(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw results::ResultError("cannot make " + folder.string() + ": " + error.message());
}

/// Copies the CAD file unless it is there; gives its name in `tools`. Contents name it, so that two files of
/// one name do not clash, and a scene names other files as soon as their contents are others.
std::string copied_tool(const fs::path& directory, const fs::path& file) {
  const std::string name = file.stem().string() + '-' + geometry::file_hash(file) + file.extension().string();
  const fs::path copy = directory / kToolFolder / name;
  if (!fs::exists(copy)) results::write_text_atomically(copy, contents_or_nothing(file));
  return name;
}

/// Makes the job's scene file; results of another scene go.
void write_scene(const fs::path& folder, const std::string& text) {
  make_folder(folder);
  if (contents_or_nothing(folder / kJobScene) == text) return;
  for (const char* outdated :
       {"report.json", "results.h5", "results.xdmf", kJobExitCode, kJobLog, results::kJobCost})
    fs::remove(folder / outdated);
  fs::remove(checkpoint_file(folder));
  results::write_text_atomically(folder / kJobScene, text);
}

/// What the run said last, without the program's name.
std::string last_complaint(const fs::path& log) {
  const std::string start = "diefill: ";
  std::istringstream lines(contents_or_nothing(log));
  std::string complaint;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(start)) complaint = line.substr(start.size());
  return complaint;
}

/// Number in the file, or -1.
int exit_code_in(const fs::path& file) {
  std::ifstream stream(file);
  int code = -1;
  stream >> code;
  return stream ? code : -1;
}

}  // namespace

results::JobList write_jobs(const fs::path& directory, const std::string& title,
                            const std::vector<Variant>& variants, int seeds) {
  make_folder(directory / kToolFolder);
  results::JobList list;
  list.title = title;
  for (const Variant& variant : variants) list.variants.push_back(variant.name);
  for (int k = 0; k < seeds; ++k)
    for (const Variant& variant : variants) {
      const std::uint64_t seed = variant.scene.seed + static_cast<std::uint64_t>(k);
      const std::string folder = variant.folder + "/seed-" + std::to_string(seed);
      std::vector<std::string> files;
      for (const ToolSpec& tool : variant.scene.tools)
        files.push_back(std::string("../../") + kToolFolder + '/' + copied_tool(directory, tool.file));
      write_scene(directory / folder, scene_text_with(variant.scene, seed, files));
      list.jobs.push_back({variant.name, seed, folder});
    }
  results::write_job_list(directory, list);
  return list;
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
    state.reason = last_complaint(folder / kJobLog);
    if (state.reason.empty()) state.reason = "ended with exit code " + std::to_string(code) + " and no word";
  }
  return state;
}

}  // namespace diefill::process
