#include "process/plan/pilot_scene.h"

#include <algorithm>

#include "process/plan/forecast.h"
#include "process/plan/setting.h"
#include "process/powder/material.h"

namespace diefill::process::plan {

namespace {

/// Fewer are not enough for costs to carry over (narrow ring: 800 grains cost as much each as 3,900).
constexpr std::size_t kMinGrains = 500;
/// With less powder than this, tools have too little to move.
constexpr double kMinPowder = 0.4;
/// Over the narrowest width: coarser grains jam, so the cost of a passage would not be representative.
constexpr double kCoarsestPilot = 0.75;

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

}  // namespace

Scene pilot_scene(const Scene& scene, const Tooling& tooling, double sphere_steps) {
  constexpr double kFiner = 1.05;
  Scene pilot = scene;
  pilot.numerics.time_step.reset();
  pilot.measure.snapshot_interval = 0;
  pilot.probes.clear();
  // Taken as soon as the poured powder rests and at intervals from then on: moments to check the time.
  SnapshotSpec snapshot;
  snapshot.name = "pilot";
  snapshot.every = 2e-3;
  pilot.snapshots = {snapshot};
  pilot.numerics.checkpoint_interval = 86400;
  const auto costs_at_most = [&](double limit) { return forecast(pilot, tooling).sphere_steps() <= limit; };
  const auto coarsen_until = [&](double limit) {
    const double largest = largest_diameter(scene, tooling);
    while (!costs_at_most(limit) && pilot.powder.grain_diameter * kFiner <= largest) {
      const Scene before = pilot;
      enlarge(pilot, kFiner);
      if (forecast(pilot, tooling).grains >= kMinGrains) continue;
      pilot = before;
      break;
    }
  };
  if (costs_at_most(sphere_steps)) return pilot;
  // Where there is nothing to fill, powder heaps up or runs out, for longer the more there is and for longer
  // than usual.
  if (!tooling.cavity.found) coarsen_until(sphere_steps / 2);
  if (costs_at_most(sphere_steps)) return pilot;
  pilot.pour.fill_height = kMinPowder * scene.pour.fill_height;
  coarsen_until(sphere_steps);
  return pilot;
}

}  // namespace diefill::process::plan
