// Speed of the engine on beds that have fallen together: sphere-steps per second for grains of model A and D,
// on one and two threads. Quote ratios within one run: machines are noisy.
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/limits/validity_monitor.h"
#include "engine/simulation/simulation.h"
#include "tests/support/contact_access.h"

namespace diefill::engine {
namespace {

/// Ground of wall spheres under a box of `width` (m), periodic in x and y.
WallBodySpec ground(double width) {
  WallBodySpec body;
  body.name = "ground";
  const double radius = body.sphere_radius, spacing = width / std::ceil(width / (1.6 * radius));
  const int reach = static_cast<int>(0.75 * width / spacing);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) body.centres.emplace_back(i * spacing, j * spacing, -radius);
  return body;
}

/// Ground and two walls across x, `width` (m) apart, that repeat along y after `length` (m).
WallBodySpec slot(double width, double length, double height) {
  WallBodySpec body;
  body.name = "slot";
  const double radius = body.sphere_radius, step = length / std::ceil(length / (1.6 * radius));
  for (double y = -0.75 * length; y < 0.75 * length; y += step) {
    for (double x = -0.5 * width; x < 0.5 * width; x += step) body.centres.emplace_back(x, y, -radius);
    for (double z = 0; z < height; z += step)
      for (const double x : {-0.5 * width - radius, 0.5 * width + radius}) body.centres.emplace_back(x, y, z);
  }
  return body;
}

/// `count` wall spheres of the same body, 50 mm below the ground: where no powder gets.
void add_far_spheres(WallBodySpec& body, int count) {
  const int across = static_cast<int>(std::sqrt(count));
  const double spacing = 1.6 * body.sphere_radius;
  for (int k = 0; k < count; ++k)
    body.centres.emplace_back((k % across - 0.5 * across) * spacing, (k / across - 0.5 * across) * spacing,
                              -0.05);
}

/// Grains on a lattice of 1.05 d, let fall for 0.03 s so that they lie on each other. `far_spheres`: on the
/// ground's body, out of reach.
Simulation fallen_bed(const GrainShape& shape, int across, int layers, int threads, int far_spheres = 0) {
  SimulationSettings settings;
  settings.types = {{shape}};
  const double radius = shape.sphere_radius;
  grain_contact(settings) = {.damping = 1e6 * radius, .tangential = 1e6 * radius, .friction = 0.5};
  wall_contact(settings) = grain_contact(settings);
  settings.time_step = 2e-6;
  settings.threads = threads;
  const double constant = 2.1 * shape.bounding_radius(), width = across * constant;
  settings.period = {width, width};
  WallBodySpec body = ground(width);
  add_far_spheres(body, far_spheres);
  Simulation simulation(settings, {body});
  std::vector<NewGrain> grains;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        NewGrain grain;
        grain.position = constant * Eigen::Vector3d(i - 0.5 * across, j - 0.5 * across, k + 0.5);
        grain.orientation = Quaternion(1, 0.3 * i, 0.2 * j, 0.1 * k);
        grains.push_back(grain);
      }
  simulation.add_grains(grains);
  for (int n = 0; n < 15000; ++n) simulation.step();
  return simulation;
}

void steps(benchmark::State& state, const GrainShape& shape, int across, int layers) {
  Simulation simulation = fallen_bed(shape, across, layers, static_cast<int>(state.range(0)));
  const auto spheres = static_cast<double>(simulation.grains().size() * shape.spheres());
  for (auto _ : state) simulation.step();
  state.counters["sphere_steps_per_second"] =
      benchmark::Counter(spheres * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["touching_pairs_per_sphere"] = static_cast<double>(simulation.touching_pairs()) / spheres;
  state.counters["spheres"] = spheres;
}

void model_a_bed(benchmark::State& state) {
  steps(state, model_a(1.5e-4, 7.63e-8), 20, 20);
}
void model_d_bed(benchmark::State& state) {
  steps(state, model_d(7.84e-5, 7.63e-8), 12, 12);
}

/// What wall spheres cost that no powder reaches: to be compared with the same bed with none.
void bed_with_far_wall_spheres(benchmark::State& state) {
  Simulation simulation = fallen_bed(model_d(7.84e-5, 7.63e-8), 48, 2, 1, static_cast<int>(state.range(0)));
  for (auto _ : state) simulation.step();
  std::size_t walls = 0;
  for (const auto& body : simulation.bodies()) walls += body.size();
  state.counters["wall_spheres"] = static_cast<double>(walls);
}

/// Coarse grains between fine walls, as in a narrow cavity: model D of 1.88 mm in a slot 9 mm wide, most of
/// whose spheres are near wall spheres of 0.15 mm.
void narrow_slot(benchmark::State& state) {
  constexpr double kWidth = 9e-3, kLength = 24e-3, kHeight = 60e-3;  // m
  const GrainShape shape = model_d(4 * 7.84e-5, 64 * 7.63e-8);
  SimulationSettings settings;
  settings.types = {{shape}};
  grain_contact(settings) = {
      .damping = 1e6 * shape.sphere_radius, .tangential = 1e6 * shape.sphere_radius, .friction = 0.5};
  wall_contact(settings) = grain_contact(settings);
  wall_contact(settings)->friction = 0.15;
  settings.time_step = 5e-6;
  settings.period[1] = kLength;
  Simulation simulation(settings, {slot(kWidth, kLength, kHeight)});
  const double constant = 2.1 * shape.bounding_radius();
  std::vector<NewGrain> grains;
  for (double z = 0.5 * constant; z < kHeight; z += constant)
    for (double y = 0.5 * (constant - kLength); y + 0.5 * constant < 0.5 * kLength; y += constant)
      for (double x = 0.5 * (constant - kWidth); x + 0.5 * constant < 0.5 * kWidth; x += constant) {
        NewGrain grain;
        grain.position = {x, y, z};
        grain.orientation = Quaternion(1, 300 * x, 200 * y, 100 * z);
        grains.push_back(grain);
      }
  simulation.add_grains(grains);
  for (int n = 0; n < 20000; ++n) simulation.step();
  const auto spheres = static_cast<double>(simulation.grains().size() * shape.spheres());
  for (auto _ : state) simulation.step();
  state.counters["sphere_steps_per_second"] =
      benchmark::Counter(spheres * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["spheres"] = spheres;
}

/// One look at the valid range; a run takes one in 200 steps. Over model_d_bed on one thread, times 200: its
/// share.
void validity_check(benchmark::State& state) {
  const Simulation simulation = fallen_bed(model_d(7.84e-5, 7.63e-8), 12, 12, 1);
  ValidityMonitor monitor;
  for (auto _ : state) monitor.check(simulation);
}

BENCHMARK(model_a_bed)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(model_d_bed)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(narrow_slot)->Unit(benchmark::kMillisecond);
BENCHMARK(validity_check)->Unit(benchmark::kMillisecond);
BENCHMARK(bed_with_far_wall_spheres)->Arg(0)->Arg(290000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace diefill::engine

BENCHMARK_MAIN();
