#include "process/results/studies/job_cost.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "process/results/storage/atomic_file.h"

namespace diefill::results {

JobCost read_job_cost(const std::filesystem::path& folder) {
  std::ifstream file(folder / kJobCost);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  const auto number = [&](const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0.0;
  };
  return {number("cpu_seconds"), number("wall_seconds"), number("peak_memory_bytes")};
}

void add_job_cost(const std::filesystem::path& folder, const JobCost& attempt) {
  const JobCost before = read_job_cost(folder);
  const nlohmann::ordered_json json = {
      {"cpu_seconds", before.cpu_seconds + attempt.cpu_seconds},
      {"wall_seconds", before.wall_seconds + attempt.wall_seconds},
      {"peak_memory_bytes", std::max(before.peak_memory_bytes, attempt.peak_memory_bytes)}};
  write_text_atomically(folder / kJobCost, json.dump(2) + "\n");
}

}  // namespace diefill::results
