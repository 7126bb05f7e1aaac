// A plan of a scene: what it needs, and its predicted cost as written and with each setting.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/plan/expected_error.h"
#include "process/plan/forecast.h"
#include "process/plan/needs.h"
#include "process/plan/pilot.h"
#include "process/plan/setting.h"

namespace diefill::process::plan {

/// One way of running the scene.
struct Choice {
  std::string name;                       ///< "as the scene has it", "quick", ...
  std::optional<SettingNumbers> numbers;  ///< nothing: the scene's own
  Forecast forecast;
  std::vector<ExpectedError> errors;  ///< to be expected; empty: not known
};

struct Plan {
  Scene scene;  ///< with the numbers of its setting, where it has one
  Tooling tooling;
  Needs needs;
  std::vector<std::string> statements;  ///< of needs, one per line
  std::optional<Pilot> pilot;
  double opening = 0;  ///< m, narrowest width of holes through the tools; 0: none, or not searched for
  double tooling_seconds = 0;   ///< s of wall-clock time to read and cover the tools
  std::vector<Choice> choices;  ///< the scene's own, then quick, working, reference where these apply
};

/// What to plan with.
struct PlanOptions {
  int threads = 2;
  bool pilot = true;             ///< run a pilot; without it wall times are unknown
  double pilot_limit = 15;       ///< s of wall-clock time
  std::filesystem::path pilots;  ///< folder where pilots are kept (pilot_cache.h); empty: none is
  bool new_pilot = false;        ///< run it even where one is kept
  /// Called with the tools and the scene on prepared steps, as soon as they are read and before the pilot
  /// runs.
  std::function<void(const Scene&, const Tooling&)> tools_ready;
  std::function<void()> pilot_starts;  ///< called before a pilot is run, not where one is kept
  /// Gives Plan::opening; empty: not searched for.
  std::function<double(const Scene&, const Tooling&)> narrowest_opening;
  ProgressCallback on_progress = ignore_progress;  ///< receives the progress of reading tools
};

/// Reads the tools, runs the pilot, and puts the plan together. Throws as a run of the scene would.
Plan make_plan(const Scene& scene, const PlanOptions& options);

/// Fills in `choices` from the scene, the tooling and the pilot.
void add_choices(Plan& plan);

/// The finest grains, down to the calibrated size, with which the working setting takes at most `minutes`
/// (wall clock). Nothing if even the coarsest grains of the quick setting take longer, no setting applies, or
/// there is no pilot.
std::optional<Choice> finest_within(const Plan& plan, double minutes);

/// Index of the choice that is cheapest among those whose errors are known and at most `error` (a share);
/// nothing if there is none.
std::optional<std::size_t> cheapest_within(const Plan& plan, double error);

}  // namespace diefill::process::plan
