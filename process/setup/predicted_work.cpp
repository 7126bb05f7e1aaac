#include "process/setup/predicted_work.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/machine/actions/powder_inflow.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/results/formatted.h"
#include "process/scene/setting.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/machine_memory.h"
#include "process/tooling/predicted_memory.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

std::string place(const Scene& scene) {
  return scene.file.string() + ": ";
}

/// Grains poured, and those that steps let in; of the half that is computed in a half model.
double all_grains(const Scene& scene) {
  const Eigen::Vector3d size = scene.pour.upper - scene.pour.lower;
  // A floating-point number: the count may exceed any integer type.
  double grains = scene.other_powders.empty()
                      ? size[0] * size[1] * scene.pour.fill_height * expected_solid_fraction(scene) /
                            mean_grain(scene).solid_volume
                      : static_cast<double>(grains_to_pour(scene));
  for (const auto& step : scene.steps)
    if (const PowderInflow* inflow = step->inflow(); inflow != nullptr && inflow->mass)
      grains += *inflow->mass / (scene.economy.mirror ? 2 : 1) / mean_of_inflow(scene, *inflow).mass;
  return grains;
}

/// s of simulated time after which the run ends in any case.
double at_most(const Scene& scene, double seconds) {
  return scene.numerics.max_time > 0 ? std::min(seconds, scene.numerics.max_time) : seconds;
}

void refuse_steps(const Scene& scene, double seconds, double time_step, double spheres) {
  const double steps = at_most(scene, seconds) / time_step;
  if (steps <= kMaxSteps && steps * spheres <= kMaxSphereSteps) return;
  const std::string advice =
      "; use a longer time step (numerics.time_step_fraction, numerics.time_step, a softer "
      "powder.reduced_modulus), larger grains or shorter steps";
  if (!(steps <= kMaxSteps))
    throw SceneError(place(scene) +
                     results::formatted("%.3g s of simulated time in time steps of %.3g s are %.3g steps, ",
                                        at_most(scene, seconds), time_step, steps) +
                     results::formatted("allowed: at most %.3g, because the run would never end", kMaxSteps) +
                     advice);
  throw SceneError(
      place(scene) +
      results::formatted("%.3g spheres over %.3g time steps of %.3g s are %.3g sphere-steps, ", spheres,
                         steps, time_step, steps * spheres) +
      results::formatted("allowed: at most %.3g, because the run would never end", kMaxSphereSteps) + advice);
}

/// Whatever max_time says: positions of tools cannot be computed after such times.
void refuse_endless_motion(const Scene& scene, double seconds) {
  constexpr double kLongest = 1e8;  // s
  if (seconds <= kLongest) return;
  throw SceneError(place(scene) +
                   results::formatted("the steps take %.3g s of simulated time, allowed: at most %.3g s; "
                                      "check whether a velocity, an acceleration or a ramp is too small",
                                      seconds, kLongest));
}

/// Bytes of what measure.snapshot_interval keeps.
double kept_bytes(const Scene& scene, double seconds, double grains) {
  constexpr double kBytesOfGrain = 100;
  return kBytesOfGrain * grains * at_most(scene, seconds) / scene.measure.snapshot_interval;
}

void refuse_snapshots(const Scene& scene, double seconds) {
  for (const auto& snapshot : scene.snapshots) {
    if (!snapshot.every || at_most(scene, seconds) / *snapshot.every <= kMaxSnapshots) continue;
    throw SceneError(
        place(scene) + "snapshot \"" + snapshot.name + "\": " +
        results::formatted(
            "every %.3g s of %.3g s makes %.3g folders of results, allowed: at most %.3g; increase every",
            *snapshot.every, at_most(scene, seconds), at_most(scene, seconds) / *snapshot.every,
            kMaxSnapshots));
  }
}

/// Grains of which so many `spheres` as fit into memory make the same powder.
std::string larger_grains(const Scene& scene, double spheres) {
  constexpr double kRoundedUp = 1.05;
  const double base = plan::predicted_memory(0, 0), room = std::max(0.1 * base, machine_memory() - base);
  const double factor = std::cbrt((plan::predicted_memory(spheres, 0) - base) / room);
  return results::formatted("use grains of %.2g mm or more (powder.grain_diameter)",
                            kRoundedUp * factor * 1e3 * scene.powder.grain_diameter) +
         ", pour less, or run on a machine with more memory";
}

}  // namespace

void refuse_memory(const std::string& what, double spheres, double wall_spheres, double more_bytes,
                   const std::string& advice) {
  const double bytes = plan::predicted_memory(spheres, wall_spheres) + more_bytes;
  const double there = machine_memory();
  if (bytes <= there) return;
  throw SceneError(what +
                   results::formatted(" would need about %.3g GB of memory, but only %.3g GB are available; ",
                                      1e-9 * bytes, 1e-9 * there) +
                   advice);
}

void refuse_excessive_work(const Scene& scene) {
  if (setting_of(scene)) return;  // its grains are not chosen yet
  const auto settings = engine_settings(scene, 1.0);
  const double grains = all_grains(scene);
  const double spheres = grains * mean_of_poured(scene).spheres;
  double longest = kSettlingGuess;
  for (const auto& step : scene.steps)
    if (!step->needs_cavity()) longest = std::max(longest, step->duration().value_or(0));
  refuse_memory(place(scene) + results::formatted("%.3g grains of %.4g mm (%.3g spheres)", grains,
                                                  1e3 * scene.powder.grain_diameter, spheres),
                spheres, 0, 0, larger_grains(scene, spheres));
  refuse_steps(scene, longest, settings.time_step, spheres);
  refuse_snapshots(scene, longest);
}

void refuse_excessive_schedule(const Scene& scene, const Tooling& tooling) {
  const Stages stages(scene);
  double end = 0;
  for (const auto& state : predicted(stages, kSettlingGuess))
    end = std::isfinite(state.ended) ? std::max(end, state.ended) : std::numeric_limits<double>::infinity();
  refuse_endless_motion(scene, end);
  const auto still = engine_settings(scene, 1.0);
  // Where a setting has still to choose them, grains are not what they will be.
  const double grains = setting_of(scene) ? 0 : all_grains(scene);
  const double spheres = grains * mean_of_poured(scene).spheres;
  refuse_steps(scene, end, still.time_step, spheres);  // before motions are asked for such times
  refuse_steps(scene, end, engine_settings(scene, predicted_impact_speed(scene, tooling)).time_step, spheres);
  refuse_snapshots(scene, end);
  if (scene.measure.snapshot_interval > 0)
    refuse_memory(
        place(scene) + results::formatted("%.3g instants of %.3g grains (measure.snapshot_interval)",
                                          at_most(scene, end) / scene.measure.snapshot_interval, grains),
        spheres, 0, kept_bytes(scene, end, grains), "keep fewer instants");
}

}  // namespace diefill::process
