#include "process/plan/pilot.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>

#include "engine/observe/powder_figures.h"
#include "process/plan/alarm.h"
#include "process/plan/forecast.h"
#include "process/plan/pilot_scene.h"
#include "process/plan/processor_use.h"
#include "process/run/fill_run.h"

namespace diefill::process::plan {

namespace {

/// A trial first measures how fast this machine computes the scene: sphere-steps, and s at most.
constexpr double kTrialSphereSteps = 3e7, kTrialSeconds = 1;
/// Share of its limit that the pilot is sized for: settling, which the trial measures, costs more than later
/// phases, but contacts with tools come later.
constexpr double kShareOfLimit = 0.6;
/// s of computing motion that are enough to measure its cost, and the largest multiple of the limit to reach
/// them or to see how long powder keeps running out.
constexpr double kMotionAtLeast = 3, kLargestOverLimit = 3;
/// Share of the predicted run time that a pilot may take, and the largest multiple of its limit: the cost of
/// a passage changes along its travel (gear: from 7.9 to 10 ns a sphere and step), and a user who waits an
/// hour for a run can wait a minute for its plan.
constexpr double kShareOfRun = 1.0 / 30, kLongestPilot = 8;

/// Folder of the pilot's checkpoints; removed at the end.
struct CheckpointFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("diefill-pilot-" + std::to_string(getpid()));
  CheckpointFolder() { std::filesystem::create_directories(path); }
  ~CheckpointFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;
};

/// Adds what a run has cost since the last call to the cost of the kind of phase it was in.
class CostMeter {
 public:
  void record(const FillRun& run, PhaseKind kind, bool whole, Pilot& pilot) {
    PhaseCost& cost = pilot.cost[static_cast<std::size_t>(kind)];
    const ProcessorUse use = processor_use();
    const double share = use.share_since(use_);
    cost.wall_seconds += share * (run.wall_seconds() - wall_);
    cost.search_seconds += share * (searched(run) - searched_);
    cost.sphere_steps += static_cast<double>(run.sphere_steps() - sphere_steps_);
    cost.seconds += run.simulation().time() - time_;
    cost.whole = whole;
    wall_ = run.wall_seconds();
    searched_ = searched(run);
    sphere_steps_ = run.sphere_steps();
    time_ = run.simulation().time();
    use_ = use;
    pilot.wall_seconds = wall_ - begun_;
    pilot.processor_share = use.share_since(use_then_);
  }
  void begin(const FillRun& run) {
    wall_ = begun_ = run.wall_seconds();
    use_ = use_then_ = processor_use();
  }

 private:
  static double searched(const FillRun& run) {
    return run.simulation().timers().seconds()[static_cast<std::size_t>(engine::Phase::search)];
  }

  double wall_ = 0, begun_ = 0, searched_ = 0, time_ = 0;
  ProcessorUse use_, use_then_;
  std::uint64_t sphere_steps_ = 0;
};

std::ptrdiff_t occurs(PhaseKind kind, const std::vector<Phase>& phases) {
  return std::count_if(phases.begin(), phases.end(), [&](const Phase& phase) { return phase.kind == kind; });
}

/// s that a pilot of `scene` may take that has gone on for `usual` (s) already.
double longer_limit(double usual, const Scene& scene, const Tooling& tooling, const Pilot& so_far) {
  const double predicted = forecast(scene, tooling, so_far).wall_seconds.value_or(0);
  return std::clamp(kShareOfRun * predicted, usual, kLongestPilot * usual);
}

/// Measured on powder that may have left the method's range: wedged grains do no harm, grains that have flown
/// beyond all bounds cannot be searched.
SizeCost size_cost_if_sound(const engine::Simulation& bed) {
  try {
    return measure_size_cost(bed);
  } catch (const engine::OutOfRange&) {
    return {};
  }
}

/// How long powder took to come to rest, as far as the pilot has seen it. `full_size`: whether it has about
/// as many grains as the run will have. In fewer, one that rolls moves the centre of mass of all too far to
/// be called rest, so that a longer time than usual says nothing about a run with more grains.
void note_rest_times(bool rests_once, bool full_size, Pilot& pilot) {
  const RestTimes usual;
  const auto at_full_size = [&](double seen, double as_usual) {
    return full_size ? seen : std::min(seen, as_usual);
  };
  const PhaseCost &fall = pilot.of(PhaseKind::fall), &rest = pilot.of(PhaseKind::rest);
  if (fall.whole)
    pilot.rest.after_fall = at_full_size(std::max(0.0, fall.seconds - pilot.fall_time), usual.after_fall);
  if (rests_once && (rest.whole || rest.seconds > usual.after_motion))
    pilot.rest.after_motion = at_full_size(rest.seconds, usual.after_motion);
}

/// What a pilot may take.
struct PilotLimits {
  double sphere_steps;  ///< predicted
  double wall;          ///< s of computing, where all phases that matter were seen by then
  double wall_at_most;  ///< s of computing, in any case
  bool quick;           ///< no longer for long scenes, and the cost of size is not measured
};

/// A run of less and coarser powder, looked at every few ms of simulated time.
class PilotRun {
 public:
  PilotRun(const Scene& scene, const Tooling& tooling, const PilotLimits& limits)
      : planned_(scene),
        tooling_(tooling),
        limits_(limits),
        scene_(pilot_scene(scene, tooling, limits.sphere_steps)),
        phases_(timeline(scene_, tooling, {})) {
    pilot_.grain_diameter = scene_.powder.grain_diameter;
    pilot_.fill_height = scene_.pour.fill_height;
    pilot_.fall_time = fall_time(scene_, tooling);
    pilot_.time_step = forecast(scene_, tooling).time_step;
  }

  Pilot run(int threads) {
    std::atomic<bool> stop{false};
    Alarm alarm(limits_.wall_at_most, stop);
    const CheckpointFolder folder;
    RunOptions options;
    options.threads = threads;
    options.show_progress = false;
    options.directory = folder.path;
    options.stop = &stop;
    options.snapshot = [&](const FillRun& run, const std::string&) {
      if (has_seen_enough(run, alarm)) stop.store(true);
    };
    FillRun run(scene_, tooling_, options);
    run_until_stopped(run);
    if (!limits_.quick) pilot_.size = size_cost_if_sound(run.simulation());
    return pilot_;
  }

 private:
  void run_until_stopped(FillRun& run) {
    meter_.begin(run);
    pilot_.spheres = engine::sphere_count(run.simulation());
    try {
      run.run();
      pilot_.stopped = run.why_unfinished();
    } catch (const Interrupted&) {
      pilot_.stopped = "time limit reached";
    } catch (const engine::OutOfRange& error) {
      pilot_.stopped = error.what();
    }
    meter_.record(run, kind_, run.schedule().finished(), pilot_);
    note_rest_times(occurs(PhaseKind::rest, phases_) == 1, has_about_as_many_grains(), pilot_);
  }

  /// Records what the run has cost, and extends the limit where the scene will take long.
  bool has_seen_enough(const FillRun& run, Alarm& alarm) {
    const PhaseKind now = kind_of(run.schedule().stages(), run.schedule().state().steps);
    meter_.record(run, kind_, now != kind_, pilot_);
    kind_ = now;
    const bool moves = occurs(PhaseKind::motion, phases_) > 0;
    const PhaseCost& motion = pilot_.of(PhaseKind::motion);
    const bool motion_seen = !moves || motion.whole || motion.wall_seconds > kMotionAtLeast;
    const bool runs_out = kind_ == PhaseKind::rest && !tooling_.cavity.found;
    if (limits_.quick || run.wall_seconds() <= limits_.wall || !motion_seen || runs_out) return false;
    const double may_take = longer_limit(limits_.wall, planned_, tooling_, pilot_);
    alarm.postpone(may_take - run.wall_seconds() + limits_.wall);
    return run.wall_seconds() > may_take;
  }

  bool has_about_as_many_grains() const {
    return !tooling_.cavity.found ||
           2 * forecast(scene_, tooling_).grains >= forecast(planned_, tooling_).grains;
  }

  const Scene& planned_;
  const Tooling& tooling_;
  PilotLimits limits_;
  Scene scene_;
  std::vector<Phase> phases_;
  PhaseKind kind_ = PhaseKind::fall;
  CostMeter meter_;
  Pilot pilot_;
};

}  // namespace

double Pilot::seconds_per_sphere_step(PhaseKind kind, double in_spheres, double searches,
                                      double near_tools) const {
  const auto from = static_cast<double>(spheres);
  const double factor = size.factor(in_spheres, from);
  const double search_factor = searches * size.search_factor(in_spheres, from);
  const auto scaled = [&](const PhaseCost& seen) {
    const double search = seen.search_seconds / seen.sphere_steps;
    const double stepping = seen.seconds_per_sphere_step() - search;
    // The cost beyond that of the same powder without tools is due to the tools.
    const double bare =
        size.points.empty() ? stepping : std::min(stepping, size.points.front().seconds_per_sphere_step);
    // Where the pilot has too little work for its threads, the tools' part is overestimated as well.
    const double tools = std::min(1.0, factor) * (stepping - bare);
    return factor * bare + near_tools * tools + search_factor * search;
  };
  if (of(kind).sphere_steps > 0) return scaled(of(kind));
  return of(PhaseKind::fall).sphere_steps > 0 ? scaled(of(PhaseKind::fall)) : 0;
}

PhaseCost Pilot::cost_of_all() const {
  PhaseCost sum;
  for (const PhaseCost& kind : cost) {
    sum.wall_seconds += kind.wall_seconds;
    sum.sphere_steps += kind.sphere_steps;
    sum.search_seconds += kind.search_seconds;
    sum.seconds += kind.seconds;
  }
  return sum;
}

Pilot run_pilot(const Scene& scene, const Tooling& tooling, int threads, double wall_limit) {
  const PilotLimits trial_limits{kTrialSphereSteps, kTrialSeconds, kTrialSeconds, true};
  const PhaseCost trial = PilotRun(scene, tooling, trial_limits).run(threads).cost_of_all();
  double affordable = kTrialSphereSteps;
  if (trial.sphere_steps > 0)
    affordable = std::max(affordable, kShareOfLimit * wall_limit / trial.seconds_per_sphere_step());
  return PilotRun(scene, tooling, {affordable, wall_limit, kLargestOverLimit * wall_limit, false})
      .run(threads);
}

}  // namespace diefill::process::plan
