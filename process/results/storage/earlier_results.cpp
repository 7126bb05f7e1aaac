#include "process/results/storage/earlier_results.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

constexpr std::array kDecisive = {"checkpoint.bin", "results.h5", "report.json"};
constexpr std::array kFiles = {"results.xdmf", "report.html", "live.html",
                               "filling.pvd",  "snapshots",   "paraview"};
constexpr std::array kPictures = {".png", ".pdf", ".mp4"};

template <class Names>
bool is_one_of(const std::string& name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether it is of a run, or in the place of what a run writes: by its name, for a user's scene and tools
/// may lie beside it. Pictures count however they are called, lest those of old results stand beside new
/// ones.
bool belongs_to_run(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (is_one_of(name, kDecisive) || is_one_of(name, kFiles)) return true;
  if (entry.is_directory())
    return name == "frames" || name.starts_with("frames_") || name.ends_with("_frames");
  if (name.starts_with("probe_") && name.ends_with(".csv")) return true;
  return is_one_of(entry.path().extension().string(), kPictures);
}

fs::path new_folder(const fs::path& directory) {
  for (int number = 1;; ++number) {
    const fs::path folder = directory / ("previous-" + std::to_string(number));
    if (!fs::exists(fs::symlink_status(folder)) && fs::create_directory(folder)) return folder;
  }
}

}  // namespace

bool would_be_moved(const fs::path& directory, const fs::path& file) {
  const fs::path from = fs::weakly_canonical(directory),
                 way = fs::weakly_canonical(file).lexically_relative(from);
  if (way == ".") return true;
  if (way.empty() || *way.begin() == "..") return false;
  return belongs_to_run(fs::directory_entry(from / *way.begin()));
}

std::optional<fs::path> back_up_results(const fs::path& directory) {
  try {
    std::vector<fs::path> files;
    if (fs::is_directory(directory))
      for (const auto& entry : fs::directory_iterator(directory))
        if (belongs_to_run(entry)) files.push_back(entry.path());
    if (files.empty()) return std::nullopt;
    const fs::path folder = new_folder(directory);
    for (const fs::path& file : files) fs::rename(file, folder / file.filename());
    return folder;
  } catch (const fs::filesystem_error& error) {
    throw ResultError("cannot back up the earlier results in " + directory.string() + ": " +
                      error.code().message() + "; choose another directory with --out");
  }
}

}  // namespace diefill::results
