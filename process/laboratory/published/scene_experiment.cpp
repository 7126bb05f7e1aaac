#include "process/laboratory/published/scene_experiment.h"

#include "process/results/storage/result_file.h"
#include "process/scene/snapshot_folder.h"

namespace diefill::process::laboratory {

std::string name_of(LabSize size) {
  return size == LabSize::coarse ? "coarse" : size == LabSize::medium ? "medium" : "published";
}

const results::FillResult& SeedResults::of(const std::string& run) const {
  return read(folders_.at(run));
}

const results::FillResult& SeedResults::at(const std::string& run, const std::string& snapshot) const {
  return read(folders_.at(run) / "snapshots" / snapshot_folder(snapshot));
}

const results::FillResult& SeedResults::read(const std::filesystem::path& folder) const {
  auto& kept = read_[folder];
  if (!kept) kept = std::make_shared<const results::FillResult>(results::read_results(folder));
  return *kept;
}

}  // namespace diefill::process::laboratory
