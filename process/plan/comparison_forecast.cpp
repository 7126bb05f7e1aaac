#include "process/plan/comparison_forecast.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "process/plan/pilot_cache.h"
#include "process/powder/law_terms.h"
#include "process/powder/material.h"
#include "process/run/powder_domain.h"
#include "process/run/restart/shared_start.h"
#include "process/run/snapshots.h"
#include "process/setup/build_tooling.h"

namespace diefill::process::plan {

namespace {

/// A variant ready to be planned.
struct Prepared {
  Scene scene;
  Tooling tooling;

  Prepared(const Variant& variant, const ProgressCallback& on_progress)
      : scene(scene_with_setting(variant.scene, std::nullopt)),
        tooling(build_tooling(scene, smallest_sphere(engine_settings(scene, 1.0)), largest_grain(scene),
                              on_progress)) {
    scene = with_prepared_steps(std::move(scene), tooling);
  }
};

std::string powder_text(const PowderSpec& powder) {
  char text[160];
  std::snprintf(text, sizeof text, "%s, %.4g mm", powder.name.c_str(), 1e3 * powder.grain_diameter);
  return powder.sizes_text.empty() ? text : powder.name + ", " + powder.sizes_text;
}

/// The pilot of the powder and its law, run with this variant if there is none yet.
const Pilot& pilot_among(const Prepared& variant, const PlanOptions& options,
                         std::vector<PowderPilot>& pilots) {
  const std::string powder = powder_text(variant.scene.powder);
  const auto laws = law_terms(variant.scene, engine_settings(variant.scene, 1.0)).used;
  const auto found = std::find_if(pilots.begin(), pilots.end(), [&](const PowderPilot& other) {
    return other.powder == powder && other.laws == laws;
  });
  if (found != pilots.end()) return found->pilot;
  pilots.push_back({powder, laws, pilot_for(variant.scene, variant.tooling, options)});
  return pilots.back().pilot;
}

/// How far a run that goes as predicted has come by `now` (s).
ScheduleState state_at(double now, std::vector<StepState> states) {
  for (auto& state : states) {
    if (state.started > now) state = StepState{};
    if (state.ended > now) state.ended = -1;
  }
  ScheduleState schedule;
  schedule.steps = std::move(states);
  return schedule;
}

/// A state that a run leaves for others, and how far it is from the end of the poured powder's settling.
struct SharedStart {
  std::uint64_t hash = 0;
  double after_fall = 0;       ///< s
  bool nothing_missed = true;  ///< a run that goes on from here still takes all of its snapshots
};

/// What the variant leaves at the end of every stage but the last; nothing where air flows (run/fill_run).
std::vector<SharedStart> shared_starts_of(const Prepared& variant, const Forecast& forecast,
                                          const RestTimes& rest) {
  if (variant.scene.suction) return {};
  const Schedule schedule(variant.scene, variant.tooling, variant.scene.powder.grain_diameter);
  const RunFrame frame{forecast.time_step, powder_domain(variant.scene, variant.tooling, schedule),
                       input_files(variant.scene.text, variant.scene.file)};
  const auto states = predicted(schedule.stages(), rest.after_motion);
  const Snapshots snapshots(variant.scene);
  double last = 0;
  for (const auto& state : states) last = std::max(last, state.ended);
  std::vector<SharedStart> shared_starts;
  for (const auto& state : states) {
    if (state.ended >= last) continue;
    const ScheduleState then = state_at(state.ended, states);
    shared_starts.push_back({start_hash(variant.scene, variant.tooling, frame, then, state.ended),
                             state.ended - states.front().ended,
                             snapshots.none_due_before(schedule.stages(), then.steps, state.ended)});
  }
  return shared_starts;
}

/// s of simulated time at the variant's beginning that have been `left` by others; `fall` (s) is how long its
/// poured powder settles.
double shared_seconds(const std::set<std::uint64_t>& left, const std::vector<SharedStart>& own, double fall) {
  double shared = 0;
  for (const SharedStart& beginning : own)
    if (beginning.nothing_missed && left.count(beginning.hash) > 0)
      shared = std::max(shared, fall + beginning.after_fall);
  return shared;
}

}  // namespace

std::optional<double> wall_seconds_after(const Forecast& forecast, double seconds) {
  if (!forecast.wall_seconds) return std::nullopt;
  double sum = 0;
  for (const auto& part : forecast.phases) {
    const double whole = part.phase.seconds;
    const double gone = std::clamp(seconds, 0.0, whole);
    if (whole > 0) sum += part.wall_seconds * (1 - gone / whole);
    seconds -= whole;
  }
  return sum;
}

ComparisonForecast forecast_comparison(const std::vector<Variant>& variants, const PlanOptions& options) {
  ComparisonForecast comparison;
  std::set<std::uint64_t> left;
  if (options.pilot) comparison.wall_seconds = 0;
  for (const Variant& variant : variants) {
    const Prepared prepared(variant, options.on_progress);
    if (options.tools_ready) options.tools_ready(prepared.scene, prepared.tooling);
    VariantForecast& own = comparison.variants.emplace_back();
    own.name = variant.name;
    RestTimes rest;
    if (options.pilot) {
      const Pilot& pilot = pilot_among(prepared, options, comparison.pilots);
      rest = pilot.rest;
      own.forecast = forecast(prepared.scene, prepared.tooling, pilot);
    } else {
      own.forecast = forecast(prepared.scene, prepared.tooling);
    }
    const auto shared_starts = shared_starts_of(prepared, own.forecast, rest);
    own.shared_seconds = shared_seconds(left, shared_starts, own.forecast.phases.front().phase.seconds);
    for (const SharedStart& beginning : shared_starts) left.insert(beginning.hash);
    own.wall_seconds = wall_seconds_after(own.forecast, own.shared_seconds);
    if (own.wall_seconds) *comparison.wall_seconds += *own.wall_seconds;
  }
  return comparison;
}

}  // namespace diefill::process::plan
