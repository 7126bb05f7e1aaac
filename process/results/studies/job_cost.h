// What a run has cost as a process of its own, kept beside its results as cost.json.
#pragma once

#include <filesystem>

namespace diefill::results {

/// Of all attempts at a run together.
struct JobCost {
  double cpu_seconds = 0;        ///< s of processor time, all threads
  double wall_seconds = 0;       ///< s of wall-clock time
  double peak_memory_bytes = 0;  ///< largest resident set
};

inline constexpr const char* kJobCost = "cost.json";

/// The cost kept in the run's folder; zeros where none is.
JobCost read_job_cost(const std::filesystem::path& folder);

/// Adds an attempt to it. Throws ResultError.
void add_job_cost(const std::filesystem::path& folder, const JobCost& attempt);

}  // namespace diefill::results
