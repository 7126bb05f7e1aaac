// The runs of a comparison: which folder below the comparison's directory holds which variant and seed. Kept
// as jobs.json, so that results can be gathered wherever and whenever they were computed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace diefill::results {

/// One run to do.
struct Job {
  std::string variant;  ///< its name in the scene
  std::uint64_t seed = 0;
  std::string folder;  ///< relative to the comparison's directory; holds scene.toml and the results
};

struct JobList {
  std::string title;                  ///< of the scene
  std::vector<std::string> variants;  ///< names, the one that others are compared with first
  std::vector<Job> jobs;
};

/// Folder of a run with `seed` in the folder `of_variant`; both relative to the comparison's directory.
std::string job_folder(const std::string& of_variant, std::uint64_t seed);

/// `directory`/jobs.json.
std::filesystem::path job_list_file(const std::filesystem::path& directory);

/// Writes `directory`/jobs.json whole or not at all. Throws ResultError.
void write_job_list(const std::filesystem::path& directory, const JobList& list);

/// Reads it. Throws ResultError, in one line, where it is missing or is no such list.
JobList read_job_list(const std::filesystem::path& directory);

}  // namespace diefill::results
