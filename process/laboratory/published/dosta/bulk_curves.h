// Bulk processes that several DEM codes ran from the same files (Dosta et al. 2024): curves of the other
// codes, and probes of our runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

/// A quantity over time, s.
struct TimeCurve {
  std::vector<double> time, value;
};

/// The curve of one other code.
struct CodeCurve {
  std::string code;
  TimeCurve curve;
};

/// Those of a case in dosta/curves.csv in the folder of scenes. Throws SceneError where that is missing or
/// wrong.
std::vector<CodeCurve> code_curves(const std::filesystem::path& scenes, const std::string& name);

/// One column of a run's probe. Throws results::ResultError where the results do not have it.
TimeCurve probe_curve(const SeedResults& seed, const std::string& run, const std::string& probe,
                      const std::string& column);

/// s, when the first step that moves `tool` began. Throws results::ResultError where none did.
double start_of_motion(const SeedResults& seed, const std::string& run, const std::string& tool);

/// Slope of the least-squares line through the values from `from` to `to` (s); NaN for less than two.
double slope_of(const TimeCurve& curve, double from, double to);

/// Value at `time` (s), linear between two; NaN beyond both ends.
double value_at(const TimeCurve& curve, double time);

}  // namespace diefill::process::laboratory
