#include "process/plan/pilot.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "process/plan/forecast.h"
#include "process/plan/setting.h"
#include "process/run/fill_run.h"
#include "process/run/material.h"

namespace diefill::process::plan {

namespace {

/// Some 10 s on two cores of 2024.
constexpr double kPilotSphereSteps = 3e8;
/// Fewer are not enough for costs to carry over (narrow ring: 800 grains cost as much each as 3,900).
constexpr std::size_t kFewestGrains = 500;
/// Less powder than this leaves the tools without what they move.
constexpr double kLeastPowder = 0.4;
/// Over the narrowest width: coarser grains jam, and cannot be what a passage costs.
constexpr double kCoarsestPilot = 0.75;

/// s of motion that say what it costs, and how many times the limit may be passed to see them or how long
/// powder goes on running out.
constexpr double kMotionAtLeast = 3, kPatience = 3;
/// Of the time that the scene will take, what a pilot may take, and over its limit at most: what a passage
/// costs changes on its way (gear: from 7.9 to 10 ns a sphere and step), and who waits for an hour may wait a
/// minute.
constexpr double kShareOfRun = 1.0 / 30, kLongestPilot = 8;

/// Sets `flag` after some time, unless it is gone by then.
class Alarm {
 public:
  Alarm(double seconds, std::atomic<bool>& flag)
      : deadline_(in(seconds)), thread_([this, &flag] {
          std::unique_lock lock(mutex_);
          while (!gone_ && Clock::now() < deadline_) changed_.wait_until(lock, deadline_);
          if (!gone_) flag.store(true);
        }) {}
  ~Alarm() {
    {
      const std::lock_guard lock(mutex_);
      gone_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  /// From now on it is `seconds` (s) that are left.
  void put_off(double seconds) {
    const std::lock_guard lock(mutex_);
    deadline_ = in(seconds);
    changed_.notify_all();
  }
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  static Clock::time_point in(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool gone_ = false;
  Clock::time_point deadline_;
  std::thread thread_;
};

/// Where the pilot's checkpoints go; gone at the end.
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

/// Books what a run has cost since the last look to the kind of phase it was in.
class Books {
 public:
  void book(const FillRun& run, PhaseKind kind, bool whole, Pilot& pilot) {
    PhaseCost& cost = pilot.cost[static_cast<std::size_t>(kind)];
    cost.wall_seconds += run.wall_seconds() - wall_;
    cost.search_seconds += searched(run) - searched_;
    cost.sphere_steps += static_cast<double>(run.sphere_steps() - sphere_steps_);
    cost.seconds += run.simulation().time() - time_;
    cost.whole = whole;
    wall_ = run.wall_seconds();
    searched_ = searched(run);
    sphere_steps_ = run.sphere_steps();
    time_ = run.simulation().time();
  }
  void begin(const FillRun& run) { wall_ = run.wall_seconds(); }

 private:
  static double searched(const FillRun& run) {
    return run.simulation().timers().seconds()[static_cast<std::size_t>(engine::Phase::search)];
  }

  double wall_ = 0, searched_ = 0, time_ = 0;
  std::uint64_t sphere_steps_ = 0;
};

double largest_diameter(const Scene& scene, const Tooling& tooling) {
  constexpr double kGrainsAcross = 4, kLargestFactor = 20;
  double largest = kLargestFactor * calibrated_diameter(scene.powder);
  const geometry::Cavity cavity = tooling.all_cavities();
  if (cavity.found && cavity.narrowest_width > 0)
    largest = std::min(largest, kCoarsestPilot * cavity.narrowest_width);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    if (scene.numerics.period[axis])
      largest = std::min(largest, *scene.numerics.period[axis] / kGrainsAcross);
    largest = std::min(largest, (scene.pour.upper[i] - scene.pour.lower[i]) / kGrainsAcross);
  }
  return std::max(largest, scene.powder.grain_diameter);
}

std::ptrdiff_t occurs(PhaseKind kind, const std::vector<Phase>& phases) {
  return std::count_if(phases.begin(), phases.end(), [&](const Phase& phase) { return phase.kind == kind; });
}

/// s that a pilot of `scene` may take that has gone on for `usual` (s) already.
double longer_limit(double usual, const Scene& scene, const Tooling& tooling, const Pilot& so_far) {
  const double foretold = forecast(scene, tooling, so_far).wall_seconds.value_or(0);
  return std::clamp(kShareOfRun * foretold, usual, kLongestPilot * usual);
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

/// How long powder took to come to rest, as far as the pilot has seen it. `alike`: whether it has about as
/// many grains as the run will have. In fewer, one that rolls moves the centre of mass of all too far to be
/// called rest, and what took longer than usual says nothing of more grains.
void note_rest_times(bool rests_once, bool alike, Pilot& pilot) {
  const RestTimes usual;
  const auto credible = [&](double seen, double otherwise) {
    return alike ? seen : std::min(seen, otherwise);
  };
  const PhaseCost &fall = pilot.of(PhaseKind::fall), &rest = pilot.of(PhaseKind::rest);
  if (fall.whole)
    pilot.rest.after_fall = credible(std::max(0.0, fall.seconds - pilot.fall_time), usual.after_fall);
  if (rests_once && (rest.whole || rest.seconds > usual.after_motion))
    pilot.rest.after_motion = credible(rest.seconds, usual.after_motion);
}

}  // namespace

double Pilot::seconds_per_sphere_step(PhaseKind kind, double in_spheres, double searches,
                                      double near_tools) const {
  const auto from = static_cast<double>(spheres);
  const double factor = size.factor(in_spheres, from);
  const double search_factor = searches * size.search_factor(in_spheres, from);
  const auto scaled = [&](const PhaseCost& seen) {
    const double search = seen.search_seconds / seen.sphere_steps;
    const double stepping = seen.seconds_per_sphere_step() - search;
    // What is more than the same powder costs without tools is theirs.
    const double bare =
        size.points.empty() ? stepping : std::min(stepping, size.points.front().seconds_per_sphere_step);
    return factor * bare + near_tools * (stepping - bare) + search_factor * search;
  };
  if (of(kind).sphere_steps > 0) return scaled(of(kind));
  double dearest = 0;
  for (const PhaseCost& other : cost)
    if (other.sphere_steps > 0) dearest = std::max(dearest, scaled(other));
  return dearest;
}

Scene pilot_scene(const Scene& scene, const Tooling& tooling, double sphere_steps) {
  constexpr double kFiner = 1.05;
  Scene pilot = scene;
  pilot.numerics.time_step.reset();
  pilot.measure.snapshot_interval = 0;
  pilot.probes.clear();
  // Called for as soon as the poured powder rests and every so often from then on: moments to look at the
  // clock.
  SnapshotSpec look;
  look.name = "pilot";
  look.every = 2e-3;
  pilot.snapshots = {look};
  pilot.numerics.checkpoint_interval = 86400;
  const auto costs_at_most = [&](double limit) { return forecast(pilot, tooling).sphere_steps() <= limit; };
  const auto coarsen_until = [&](double limit) {
    const double largest = largest_diameter(scene, tooling);
    while (!costs_at_most(limit) && pilot.powder.grain_diameter * kFiner <= largest) {
      const PowderSpec before = pilot.powder;
      enlarge(pilot.powder, kFiner);
      if (forecast(pilot, tooling).grains >= kFewestGrains) continue;
      pilot.powder = before;
      break;
    }
  };
  // Where there is nothing to fill, powder heaps up or runs out, for longer the more there is and for longer
  // than usual.
  if (!tooling.cavity.found) coarsen_until(sphere_steps / 2);
  if (costs_at_most(sphere_steps)) return pilot;
  pilot.pour.fill_height = kLeastPowder * scene.pour.fill_height;
  coarsen_until(sphere_steps);
  return pilot;
}

Pilot run_pilot(const Scene& scene, const Tooling& tooling, int threads, double wall_limit) {
  const Scene short_scene = pilot_scene(scene, tooling, kPilotSphereSteps);
  Pilot pilot;
  pilot.grain_diameter = short_scene.powder.grain_diameter;
  pilot.fill_height = short_scene.pour.fill_height;
  pilot.fall_time = fall_time(short_scene, tooling);
  pilot.time_step = forecast(short_scene, tooling).time_step;
  const auto phases = timeline(short_scene, tooling, pilot.rest);
  const bool moves = occurs(PhaseKind::motion, phases) > 0;
  PhaseKind kind = PhaseKind::fall;
  Books books;
  std::atomic<bool> stop{false};
  Alarm alarm(kPatience * wall_limit, stop);
  RunOptions options;
  options.threads = threads;
  options.show_progress = false;
  const CheckpointFolder folder;
  options.directory = folder.path;
  options.stop = &stop;
  options.snapshot = [&](const FillRun& run, const std::string&) {
    const PhaseKind now = kind_of(run.schedule().stages(), run.schedule().state().steps);
    books.book(run, kind, now != kind, pilot);
    kind = now;
    const PhaseCost& motion = pilot.of(PhaseKind::motion);
    const bool motion_seen = !moves || motion.whole || motion.wall_seconds > kMotionAtLeast;
    const bool runs_out = kind == PhaseKind::rest && !tooling.cavity.found;
    if (run.wall_seconds() <= wall_limit || !motion_seen || runs_out) return;
    const double may_take = longer_limit(wall_limit, scene, tooling, pilot);
    alarm.put_off(may_take - run.wall_seconds() + wall_limit);
    if (run.wall_seconds() > may_take) stop.store(true);
  };
  FillRun run(short_scene, tooling, options);
  books.begin(run);
  pilot.spheres = run.simulation().grains().size() * run.simulation().settings().shape.spheres();
  try {
    run.run();
  } catch (const Interrupted&) {
    pilot.stopped = "its time was over";
  } catch (const engine::OutOfRange& error) {
    pilot.stopped = error.what();
  }
  books.book(run, kind, run.schedule().finished(), pilot);
  pilot.size = size_cost_if_sound(run.simulation());
  for (const PhaseCost& cost : pilot.cost) pilot.wall_seconds += cost.wall_seconds;
  const bool alike =
      !tooling.cavity.found || 2 * forecast(short_scene, tooling).grains >= forecast(scene, tooling).grains;
  note_rest_times(occurs(PhaseKind::rest, phases) == 1, alike, pilot);
  return pilot;
}

}  // namespace diefill::process::plan
