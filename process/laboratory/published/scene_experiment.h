// An experiment of the sources as scenes and their evaluation: which scenes are run, what is measured in
// their results, and which published figure that is compared with. To add one: a file with a function like
// `plan`, its line in registry.cpp, and its rows in EXPERIMENTS of
// sample_tools/laboratory/make_published_figures.py.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "process/laboratory/published/custom_run.h"
#include "process/results/fill_result.h"
#include "process/results/studies/experiment_result.h"
#include "process/scene/variants.h"

namespace diefill::process::laboratory {

/// How large: four times, twice and once the published grain size, unless the experiment says otherwise.
enum class LabSize { coarse, medium, published };

/// "coarse", "medium" or "published".
std::string name_of(LabSize size);

/// Settings of an experiment.
struct LabSetting {
  LabSize size = LabSize::coarse;
  std::filesystem::path scenes;  ///< folder of the scene files
  std::filesystem::path powder;  ///< scene or powder file whose powder replaces all others; empty: none
  /// Enlargement of grains that goes with the size.
  double scale() const { return size == LabSize::coarse ? 4 : size == LabSize::medium ? 2 : 1; }
};

/// One scene of an experiment; it runs with every seed.
struct LabRun {
  std::string name;      ///< unique in the experiment
  std::string scene;     ///< file in the folder of scenes
  SceneChanges changes;  ///< of that file
};

/// The results of one seed, read on demand.
class SeedResults {
 public:
  /// `folders` of the runs that are finished, and results of `own` runs (custom_run.h), by name.
  SeedResults(std::uint64_t seed, std::map<std::string, std::filesystem::path> folders,
              std::map<std::string, std::string> own = {})
      : seed_(seed), folders_(std::move(folders)), own_(std::move(own)) {}

  std::uint64_t seed() const { return seed_; }
  bool has(const std::string& run) const { return folders_.contains(run) || own_.contains(run); }
  /// Throws results::ResultError, and std::out_of_range for a run that is not finished.
  const results::FillResult& of(const std::string& run) const;
  /// At a [[snapshot]] of the scene.
  const results::FillResult& at(const std::string& run, const std::string& snapshot) const;
  /// Of one of the experiment's own. Throws std::out_of_range for one that is not finished.
  const std::string& own(const std::string& run) const { return own_.at(run); }

 private:
  const results::FillResult& read(const std::filesystem::path& folder) const;

  std::uint64_t seed_;
  std::map<std::string, std::filesystem::path> folders_;
  std::map<std::string, std::string> own_;
  mutable std::map<std::filesystem::path, std::shared_ptr<const results::FillResult>> read_;
};

/// One number that an experiment measures with every seed.
struct LabQuantity {
  std::string id;                 ///< of the published figure, or the experiment's own
  std::string quantity, unit;     ///< of one that is not published; empty: those of the published figure
  std::vector<std::string> runs;  ///< whose results it takes
  /// In `unit`, NaN where the results do not have it.
  std::function<double(const SeedResults&)> value;
  /// In its place, of one that follows from all seeds together, such as scatter; two at least.
  std::function<double(const std::vector<SeedResults>&)> over_seeds = {};
};

/// Charts of one seed, as far as its runs are finished; charts_over_seeds.h puts those of all seeds together.
using LabCharts = std::function<std::vector<results::ExperimentChart>(const SeedResults&)>;

struct LabPlan {
  std::vector<LabRun> runs;
  std::vector<LabQuantity> quantities;
  LabCharts charts;                         ///< nothing: none
  std::vector<CustomRun> custom_runs = {};  ///< that no scene file can describe
};

struct SceneExperiment {
  std::string name;      ///< on the command line and of its files
  std::string question;  ///< one line
  LabPlan (*plan)(const LabSetting&);
};

/// All of them. To add one: its line in registry.cpp.
const std::vector<SceneExperiment>& scene_experiments();

}  // namespace diefill::process::laboratory
