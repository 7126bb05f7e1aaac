#include "process/plan/size_cost.h"

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation.h"
#include "process/plan/processor_use.h"

namespace diefill::process::plan {

namespace {

/// More than fits the largest cache: on an EPYC with 32 MiB clumps cost 1.08 times as much with 441,000
/// spheres as with 49,000, and 1.23 times with 784,000.
constexpr double kMaxSpheres = 1e6;
/// Steps before timing, and timed.
constexpr int kWarmUp = 3, kSteps = 40;
/// Of the bed's own time step. Without tools a bed comes apart within some tens of steps, and what a contact
/// costs would be missing from the longer ones: in steps so short everything stays where it is.
constexpr double kStandstill = 1e-6;
/// Beds are stepped again until this much has been timed, s.
constexpr double kLongEnough = 0.25;

std::size_t spheres_in(const engine::Simulation& bed) {
  std::size_t spheres = 0;
  for (std::size_t k = 0; k < bed.grains().size(); ++k) spheres += bed.shape_of(k).spheres();
  return spheres;
}

/// The settings of a bed for copies of it that stand free and still.
engine::SimulationSettings free_standing(const engine::Simulation& bed) {
  engine::SimulationSettings settings = bed.settings();
  settings.time_step *= kStandstill;
  settings.period = {};
  settings.sleep.reset();
  settings.air_flow.reset();
  return settings;
}

/// `copies` x `copies` of a bed side by side along x and y, at a distance at which they do not touch.
std::vector<engine::NewGrain> side_by_side(const engine::Simulation& bed, int copies) {
  const engine::Grains& grains = bed.grains();
  Eigen::AlignedBox3d box;
  double reach = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    box.extend(grains.position[k]);
    reach = std::max(reach, bed.shape_of(k).bounding_radius());
  }
  const Eigen::Vector3d apart = box.sizes() + Eigen::Vector3d::Constant(4 * reach);
  std::vector<engine::NewGrain> all;
  all.reserve(static_cast<std::size_t>(copies) * static_cast<std::size_t>(copies) * grains.size());
  for (int j = 0; j < copies; ++j)
    for (int i = 0; i < copies; ++i)
      for (std::size_t k = 0; k < grains.size(); ++k) {
        engine::NewGrain& grain = all.emplace_back();
        grain.position = grains.position[k] + Eigen::Vector3d(i * apart.x(), j * apart.y(), 0);
        grain.velocity = grains.velocity[k];
        if (!grains.orientation.empty())
          grain.orientation = grains.orientation[k];  // single spheres have none
        grain.angular_velocity = bed.angular_velocity(k);
        grain.kind = grains.type_of(k);
      }
  return all;
}

double seconds_of(engine::Simulation& simulation, int steps) {
  const FreeClock clock;
  for (int k = 0; k < steps; ++k) simulation.step();
  return clock.seconds();
}

/// s that making the neighbour list takes: nearly all of what going back to a state does.
double search_seconds(engine::Simulation& simulation) {
  const engine::Snapshot now = simulation.snapshot();
  const FreeClock clock;
  simulation.restore(now);
  return clock.seconds();
}

}  // namespace

double SizeCost::factor_of(double Point::*cost, double spheres, double from) const {
  if (points.empty()) return 1;
  const auto cost_of = [&](double number) {
    const auto above = std::find_if(points.begin(), points.end(),
                                    [&](const Point& point) { return point.spheres >= number; });
    if (above == points.begin()) return *above.*cost;
    if (above == points.end()) return points.back().*cost;
    const Point &low = above[-1], &high = *above;
    const double share = std::log(number / low.spheres) / std::log(high.spheres / low.spheres);
    return std::lerp(low.*cost, high.*cost, share);
  };
  return cost_of(spheres) / cost_of(from);
}

double SizeCost::factor(double spheres, double from) const {
  return factor_of(&Point::seconds_per_sphere_step, spheres, from);
}

double SizeCost::search_factor(double spheres, double from) const {
  return factor_of(&Point::search_seconds, spheres, from);
}

SizeCost measure_size_cost(const engine::Simulation& bed) {
  SizeCost cost;
  const auto once = static_cast<double>(spheres_in(bed));
  const engine::SimulationSettings settings = free_standing(bed);
  for (int copies = 1; once > 0 && copies * copies * once <= kMaxSpheres; copies += std::max(1, copies / 2)) {
    const auto grains = side_by_side(bed, copies);
    double seconds = 0, search = 0, times = 0;
    while (seconds < kLongEnough) {
      engine::Simulation simulation(settings, {});
      simulation.add_grains(grains);
      seconds_of(simulation, kWarmUp);
      seconds += seconds_of(simulation, kSteps);
      search += search_seconds(simulation);
      ++times;
    }
    const double spheres = copies * copies * once;
    cost.points.push_back({spheres, seconds / (times * kSteps * spheres), search / (times * spheres)});
  }
  return cost;
}

}  // namespace diefill::process::plan
