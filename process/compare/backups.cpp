#include "process/compare/backups.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "process/results/storage/result_file.h"
#include "process/results/studies/job_list.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw results::ResultError("cannot back up " + path.string() + ": " + error.message() +
                             "; choose another directory");
}

/// `start` and the first number that no file or folder has after it.
fs::path first_free(const fs::path& start) {
  for (int number = 1;; ++number) {
    fs::path path = start;
    path += std::to_string(number);
    if (fs::symlink_status(path).type() == fs::file_type::not_found) return path;
  }
}

/// Moves those of `files` that are there.
fs::path move_to_backup(const fs::path& directory, const std::vector<fs::path>& files) {
  const fs::path folder = first_free(directory / "previous-");
  make_folder(folder);
  for (const fs::path& file : files) {
    std::error_code error;
    if (!fs::exists(file)) continue;
    fs::rename(file, folder / file.filename(), error);
    if (error) fail(file, error);
  }
  return folder;
}

std::vector<fs::path> files_that_begin(const fs::path& directory, const std::vector<std::string>& starts) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    const auto begins_it = [&](const std::string& start) { return name.starts_with(start); };
    if (entry.is_regular_file() && std::any_of(starts.begin(), starts.end(), begins_it))
      files.push_back(entry.path());
  }
  return files;
}

/// Whether `is_there` holds for every entry of the document's `list`; false where the document cannot be
/// read.
bool all_there(const fs::path& file, const char* list, const std::function<bool(const Json&)>& is_there) {
  if (!fs::is_regular_file(file)) return false;
  std::ifstream stream(file);
  const Json document = Json::parse(stream, nullptr, false);
  if (!document.is_object() || !document.contains(list) || !document[list].is_array()) return false;
  try {
    return std::all_of(document[list].begin(), document[list].end(), is_there);
  } catch (const Json::exception&) {
    return false;
  }
}

/// Whether the values are the same but for the digits that a file keeps.
bool same_values(const std::vector<double>& one, const std::vector<double>& other) {
  constexpr double kDigits = 1e-9;
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](double a, double b) {
    return std::abs(a - b) <= kDigits * std::max(std::abs(a), std::abs(b));
  });
}

/// Whether a calibration.json has a powder: the region that agrees is given by samples.
bool has_fit(const fs::path& table) {
  std::ifstream stream(table);
  const Json document = Json::parse(stream, nullptr, false);
  return document.is_object() && document.contains("samples") && !document["samples"].empty();
}

/// Whether powder.toml in the directory is that of an earlier fit, and `now` has written none. Beside a
/// screening it may be a powder of the user's own, unless the table there is that of a fit.
bool powder_of_earlier_fit(const fs::path& directory, const results::Calibration& now) {
  if (now.fitted || !fs::exists(directory / "powder.toml")) return false;
  return now.screening.quantities.empty() || has_fit(directory / "calibration.json");
}

/// Whether `now` has everything that an earlier calibration.json states.
bool has_all_of(const fs::path& table, const results::Calibration& now) {
  if (has_fit(table) && !now.fitted) return false;
  return all_there(table, "points", [&](const Json& point) {
    const std::string role = point.at("role");
    if (point.at("state") != "finished" || role == "best" || role == "edge" || role == "finer") return true;
    const auto values = point.at("values").get<std::vector<double>>();
    return std::any_of(now.points.begin(), now.points.end(), [&](const results::CalibrationPoint& other) {
      return other.state == "finished" && other.role == role && same_values(values, other.values);
    });
  });
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw results::ResultError("cannot create " + folder.string() + ": " + error.message());
}

fs::path back_up(const fs::path& path) {
  const fs::path renamed = first_free(path.string() + "-previous-");
  std::error_code error;
  fs::rename(path, renamed, error);
  if (error) fail(path, error);
  return renamed;
}

std::optional<fs::path> back_up_earlier_tables(const fs::path& directory, const results::Comparison& now) {
  const fs::path table = directory / "comparison.json";
  const auto is_there = [&](const Json& run) {
    if (run.at("state") != "finished") return true;
    return std::any_of(now.runs.begin(), now.runs.end(), [&](const results::ComparedRun& other) {
      return other.state == "finished" && run.at("folder") == other.folder &&
             run.at("state_hash") == other.state_hash;
    });
  };
  // The JSON is written first: without it, the other files are not of a comparison.
  const std::vector<fs::path> others = {directory / "comparison.csv", directory / "comparison.png"};
  const bool foreign =
      std::any_of(others.begin(), others.end(), [](const auto& file) { return fs::exists(file); });
  if (!fs::exists(table)) return foreign ? std::optional(move_to_backup(directory, others)) : std::nullopt;
  if (all_there(table, "runs", is_there)) return std::nullopt;
  return move_to_backup(directory, files_that_begin(directory, {"comparison."}));
}

std::optional<fs::path> back_up_earlier_tables(const fs::path& directory, const results::Tradeoff& now) {
  const fs::path table = directory / "tradeoff.json";
  const auto is_there = [&](const Json& setting) {
    if (setting.at("seeds") == 0) return true;
    return std::any_of(now.points.begin(), now.points.end(), [&](const results::TradeoffPoint& other) {
      return setting.at("setting") == other.name && setting.at("seeds") <= other.seeds;
    });
  };
  if (!fs::exists(table) || all_there(table, "settings", is_there)) return std::nullopt;
  return move_to_backup(directory, files_that_begin(directory, {"tradeoff.", "parameter_"}));
}

std::optional<fs::path> back_up_earlier_tables(const fs::path& directory, const results::Calibration& now) {
  std::vector<fs::path> files;
  for (const std::string& name : results::calibration_tables())
    if (fs::exists(directory / name)) files.push_back(directory / name);
  if (!files.empty() && has_all_of(directory / "calibration.json", now)) files.clear();
  if (powder_of_earlier_fit(directory, now)) files.push_back(directory / "powder.toml");
  if (files.empty()) return std::nullopt;
  return move_to_backup(directory, files);
}

std::optional<fs::path> back_up_files(const fs::path& directory, const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names)
    if (fs::exists(directory / name)) files.push_back(directory / name);
  if (files.empty()) return std::nullopt;
  return move_to_backup(directory, files);
}

std::optional<fs::path> back_up_tables(const fs::path& directory) {
  const std::vector<std::string> endings = {".csv", ".json", ".png", ".html", ".pdf", ".mp4"};
  std::vector<fs::path> files;
  if (!fs::is_directory(directory)) return std::nullopt;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_regular_file() && entry.path() != results::job_list_file(directory) &&
        std::find(endings.begin(), endings.end(), ending) != endings.end())
      files.push_back(entry.path());
  }
  if (files.empty()) return std::nullopt;
  return move_to_backup(directory, files);
}

}  // namespace diefill::process
