// Runs a scene over settings, each with several seeds, and reports their cost and error. The runs are jobs of
// diefill compare: self-contained folders, kept when finished, continued when not.
#pragma once

#include <map>

#include "process/compare/job_folder.h"
#include "process/compare/run_jobs.h"
#include "process/results/studies/tradeoff.h"
#include "process/tradeoff/settings.h"

namespace diefill::process {

struct TradeoffOptions {
  std::filesystem::path directory;        ///< of the jobs; must be there
  int seeds = 1;                          ///< runs of each setting, seeds counted up from the scene's
  double tolerance = 0;                   ///< error that is accepted, a fraction
  std::map<std::string, double> targets;  ///< published values by key of the quantity, in its unit
  std::string reference;  ///< name of the setting to compare others with; empty: reference_setting
  JobOptions jobs;        ///< with the budget as `cpu_seconds`; `starts` is set here
  bool variants = false;  ///< the scene's variants are settings too
  std::string command;    ///< for the record
  NoteCallback on_note;   ///< receives notes on earlier runs that were renamed
};

/// What to try of a scene.
struct TradeoffPlan {
  std::vector<ParameterValues> parameters;
  std::vector<TriedSetting> settings;  ///< the base first
};

/// The parameters with these values, usual_parameters where there are none nor variants, and their settings.
/// Throws SceneError for values that the scene refuses (usual ones are noted in their setting), for unknown
/// names in `options` and for seeds beyond the largest.
TradeoffPlan plan_tradeoff(const Scene& scene, const std::vector<ParameterValues>& parameters,
                           const TradeoffOptions& options);

/// A line for each of the `targets` whose quantity has no value in any setting, so that it does not count.
std::vector<std::string> remarks_on_targets(const results::Tradeoff& tradeoff,
                                            const std::map<std::string, double>& targets);

/// Runs the plan, and then all worthwhile parameters turned together. Throws Interrupted when asked to stop,
/// results::ResultError and std::runtime_error as run_jobs does.
results::Tradeoff trade_off(const Scene& scene, TradeoffPlan plan, const TradeoffOptions& options);

}  // namespace diefill::process
