#include "process/results/studies/job_list.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

JobList from_json(const Json& json) {
  JobList list;
  list.title = json.at("title");
  list.variants = json.at("variants");
  for (const Json& entry : json.at("jobs")) {
    list.jobs.push_back({entry.at("variant"), entry.at("seed"), entry.at("folder")});
    const auto known = std::find(list.variants.begin(), list.variants.end(), list.jobs.back().variant);
    if (known == list.variants.end()) throw std::invalid_argument("a job of an unknown variant");
    // Otherwise a list could refer to files outside its directory, which are not its runs.
    const std::filesystem::path folder = list.jobs.back().folder;
    if (folder.empty() || folder.is_absolute() || folder.lexically_normal().begin()->string() == "..")
      throw std::invalid_argument("a job outside the list's directory");
  }
  if (list.variants.empty()) throw std::invalid_argument("no variant");
  return list;
}

}  // namespace

std::string job_folder(const std::string& of_variant, std::uint64_t seed) {
  return of_variant + "/seed-" + std::to_string(seed);
}

std::filesystem::path job_list_file(const std::filesystem::path& directory) {
  return directory / "jobs.json";
}

void write_job_list(const std::filesystem::path& directory, const JobList& list) {
  Json json;
  json["title"] = list.title;
  json["variants"] = list.variants;
  json["jobs"] = Json::array();
  for (const Job& job : list.jobs)
    json["jobs"].push_back({{"variant", job.variant}, {"seed", job.seed}, {"folder", job.folder}});
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_text_atomically(job_list_file(directory), text);
}

JobList read_job_list(const std::filesystem::path& directory) {
  const auto path = job_list_file(directory);
  std::ifstream file(path);
  if (!file)
    throw ResultError(path.string() +
                      ": cannot be read; give a directory of diefill compare --out or --export-jobs");
  try {
    return from_json(Json::parse(file));
  } catch (const std::exception&) {
    throw ResultError(path.string() + ": not a valid job list; run diefill compare to write it again");
  }
}

}  // namespace diefill::results
