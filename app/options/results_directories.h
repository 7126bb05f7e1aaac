// Results directories given twice: they would count as two runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::app {

/// Throws process::SceneError, in one line, where two of `directories` are the same, also by another path or
/// a link. `what` names the argument, such as "DIR".
void require_distinct(const std::string& what, const std::vector<std::filesystem::path>& directories);

/// A results directory that was read.
struct ReadDirectory {
  std::filesystem::path directory;
  const results::FillResult* result = nullptr;
};

/// Throws process::SceneError, in one line that names both directories, where one holds a copy of another's
/// results: the same scene and seed, and the same final state to the last bit.
void require_no_copies(const std::string& what, const std::vector<ReadDirectory>& directories);

}  // namespace diefill::app
