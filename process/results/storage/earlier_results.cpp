#include "process/results/storage/earlier_results.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "process/results/storage/result_file.h"
#include "process/results/studies/measured_files.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFiles = {"checkpoint.bin",   "checkpoint.inputs",
                               "results.h5",       "report.json",
                               "results.xdmf",     "report.html",
                               "report.pdf",       "live.html",
                               "filling.pvd",      "snapshots",
                               "paraview",         "film.mp4",
                               "turntable.mp4",    "turntable_compared.mp4",
                               "film_compared.mp4"};

/// What runs, and diefill map with its kinds of picture, call their PNG and PDF files.
constexpr std::array kPictures = {"azimuth_profile",
                                  "coordination",
                                  "density_map",
                                  "difference",
                                  "displacement",
                                  "fill_level",
                                  "fill_level_map",
                                  "height_profile",
                                  "histogram",
                                  "map",
                                  "partial_volumes",
                                  "plan_map",
                                  "pressure",
                                  "pressure_section",
                                  "probe",
                                  "section",
                                  "size_map",
                                  "size_section",
                                  "snapshot",
                                  "velocity",
                                  "velocity_section",
                                  "view"};

template <class Names>
bool is_one_of(const std::string& name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// `name` without what stands after it where there are several: "_2" of sections, "_cavity_2" of cavities.
std::string without_number(std::string name) {
  const std::string cavity = "_cavity";
  const std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size() || name[end] != '_') return name;
  name.erase(end);
  if (name.ends_with(cavity)) name.erase(name.size() - cavity.size());
  return name;
}

/// Whether it is what diefill map --measured has written: its table tells.
bool is_of_measured(const fs::path& file) {
  const std::string start = "measured_", name = file.filename().string();
  if (!name.starts_with(start)) return false;
  for (const std::string end : {"_zones.csv", ".csv", "_difference.png", ".png"})
    if (name.size() > start.size() + end.size() && name.ends_with(end) &&
        !foreign_measured_file(file.parent_path(),
                               name.substr(start.size(), name.size() - start.size() - end.size())))
      return true;
  return false;
}

bool is_picture(const fs::path& file) {
  const std::string ending = file.extension().string();
  return (ending == ".png" || ending == ".pdf") && is_one_of(without_number(file.stem().string()), kPictures);
}

/// Of several results, each has its film beside its frames.
bool is_film(const fs::path& file) {
  const std::string stem = file.stem().string(), start = "film_";
  std::error_code none;
  return file.extension() == ".mp4" && stem.starts_with(start) &&
         fs::is_directory(file.parent_path() / ("frames_" + stem.substr(start.size())), none);
}

/// Frames of a film have numbers for names.
bool holds_frames_only(const fs::path& folder) {
  const auto is_frame = [](const fs::directory_entry& entry) {
    return entry.path().extension() == ".png" &&
           entry.path().stem().string().find_first_not_of("0123456789") == std::string::npos;
  };
  std::error_code unreadable;
  return std::all_of(fs::directory_iterator(folder, unreadable), fs::directory_iterator(), is_frame);
}

bool is_folder_of_frames(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return entry.is_directory() &&
         (name == "frames" || name.starts_with("frames_") || name.ends_with("_frames")) &&
         holds_frames_only(entry.path());
}

/// Whether it is called as what this program writes about a run: a user's scene, tools and pictures may lie
/// beside that.
bool belongs_to_run(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (is_one_of(name, kFiles)) return true;
  if (entry.is_directory()) return is_folder_of_frames(entry);
  if (name.starts_with("probe_") && name.ends_with(".csv")) return true;
  return is_picture(entry.path()) || is_film(entry.path()) || is_of_measured(entry.path());
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
