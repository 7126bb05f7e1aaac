// A simulation that no scene file can describe, which an experiment sets up itself. Its result is stored in a
// folder of its own, and it resumes from its checkpoint where it was stopped (custom_runs.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace diefill::process::laboratory {

/// Monitors a run in progress.
class CustomRunWatch {
 public:
  virtual ~CustomRunWatch() = default;
  /// For files beside the result.
  virtual const std::filesystem::path& folder() const = 0;
  /// State that the run stored when it was stopped; empty: it begins.
  virtual const std::string& begun() const = 0;
  /// To be called every few steps, with the share that is done, 0 to 1. Now and then, and when the run is to
  /// stop, `state` is called for what it resumes from. Throws CustomRunStopped in the latter case.
  virtual void report(double share, const std::function<std::string()>& state) = 0;
};

struct CustomRun {
  std::string name;      ///< unique in the experiment; that of its folder: letters, digits, _ . -
  std::string settings;  ///< in one line, all but the seed that its result depends on
  double work = 0;       ///< particle steps, about
  /// Its result as text.
  std::function<std::string(std::uint64_t seed, CustomRunWatch& watch)> make;
};

}  // namespace diefill::process::laboratory
