// What a longer step does to flow: powder runs out of a box through a slit beside its side wall and leaves a
// heap.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <random>
#include <string>

#include "engine/limits/validity_monitor.h"
#include "engine/simulation/simulation.h"
#include "process/input/scene_error.h"
#include "process/laboratory/stability/profile_walls.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"
#include "process/measure/figures/heap_slope.h"
#include "process/powder/material.h"
#include "process/tooling/rest.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;

constexpr double kPublished = 2e-6 / 0.47e-3;  // s/m, step over d (Bierwisch 2009, Table C.4)
constexpr double kFloor = 25e-3, kSlit = 10e-3, kTop = 200e-3;  // m
constexpr double kRemoved = -15e-3;                             // m, where powder is taken out

/// The default powder (model D) in a box of kFloor + kSlit across x, periodic in y.
struct FlowCase {
  double diameter = 0, fill = 0;  ///< m
  double factor = 1;              ///< of the published step
  std::uint64_t seed = 1;
  int threads = 1;

  double length() const { return 4 * diameter; }
};

struct FlowFigures {
  double rate = std::nan("");   ///< kg/s a metre of slit, while 10 to 60 % of what runs out does
  double slope = std::nan("");  ///< degrees, of the heap that stays
  double cpu_seconds = std::nan("");
};

engine::WallBodySpec box_of(const FlowCase& flow) {
  engine::WallBodySpec body;
  body.name = "box";
  const double end = kFloor + kSlit, half = 1.5 * flow.length();
  add_along_y(body, {{0, kTop}, {0, 0}, {kFloor, 0}, {kFloor, 2 * kRemoved}}, half);
  add_along_y(body, {{end, 2 * kRemoved}, {end, kTop}}, half);
  return body;
}

/// Closes the slit until it is drawn away downwards.
engine::WallBodySpec gate_of(const FlowCase& flow) {
  engine::WallBodySpec body;
  body.name = "gate";
  add_along_y(body, {{kFloor, 0}, {kFloor + kSlit, 0}}, 1.5 * flow.length());
  return body;
}

std::vector<engine::NewGrain> lattice(const FlowCase& flow, double solid_volume) {
  const double spacing = 1.15 * flow.diameter, half = 0.5 * flow.length();
  const auto wanted =
      static_cast<std::size_t>(0.39 * (kFloor + kSlit) * flow.length() * flow.fill / solid_volume);
  std::mt19937_64 generator(flow.seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<engine::NewGrain> grains;
  for (int layer = 0; grains.size() < wanted; ++layer)
    for (double y = -half + 0.5 * spacing; y < half - 0.4 * spacing; y += spacing)
      for (double x = 0.55 * spacing; x < kFloor + kSlit - 0.5 * spacing; x += spacing) {
        engine::NewGrain grain;
        grain.position = {x, y, (layer + 0.6) * spacing};
        grain.orientation =
            engine::Quaternion(uniform(generator), uniform(generator), uniform(generator), uniform(generator))
                .normalized();
        grains.push_back(grain);
      }
  return grains;
}

void run_until_rest(engine::Simulation& simulation, double diameter, double longest,
                    const std::function<void()>& sample) {
  RestWatch rest;
  engine::ValidityMonitor monitor;
  const double end = simulation.time() + longest;
  do {
    for (int k = 0; k < 50; ++k) simulation.step();
    monitor.check(simulation);
    sample();
  } while (simulation.time() < end && !rest.at_rest(simulation, diameter));
}

/// Time (s) at which `count` grains had left, between those that were noted.
double time_of(const std::vector<std::pair<double, double>>& left, double count) {
  for (std::size_t k = 1; k < left.size(); ++k)
    if (left[k].second >= count) return left[k].first;
  return std::nan("");
}

FlowFigures flow_out(const FlowCase& flow) {
  Scene scene;
  scene.powder.grain_diameter = flow.diameter;
  scene.numerics.period[1] = flow.length();
  scene.numerics.time_step = flow.factor * kPublished * flow.diameter;
  auto settings = engine_settings(scene, 0.7);
  settings.threads = flow.threads;
  engine::Simulation simulation(settings, {box_of(flow), gate_of(flow)});
  simulation.add_grains(lattice(flow, settings.shape().solid_volume));
  run_until_rest(simulation, flow.diameter, 0.4, [] {});
  const double opened = simulation.time();
  simulation.set_motion(1, [opened](double time) {
    constexpr double kSpeed = 2;  // m/s, faster than powder falls
    engine::BodyMotion motion;
    motion.translation.z() = -kSpeed * std::max(0.0, time - opened);
    motion.velocity.z() = -kSpeed;
    return motion;
  });
  double gone = 0;
  std::vector<std::pair<double, double>> left = {{opened, 0}};
  run_until_rest(simulation, flow.diameter, 1.0, [&] {
    gone += static_cast<double>(
        simulation.remove_grains([](const Eigen::Vector3d& place) { return place.z() < kRemoved; }));
    left.emplace_back(simulation.time(), gone);
  });
  FlowFigures figures;
  figures.rate = 0.5 * gone * settings.shape().mass /
                 ((time_of(left, 0.6 * gone) - time_of(left, 0.1 * gone)) * flow.length());
  results::PowderState powder;
  powder.grain_diameter = flow.diameter;
  powder.position = simulation.grains().position;
  figures.slope = heap_slope(powder, {0, -flow.length(), 0}, {kFloor, flow.length(), kTop});
  return figures;
}

/// As flow_out(), with the processor time; no figures where the step was refused or the validity check
/// stopped the run.
FlowFigures figures_of(const FlowCase& flow) {
  const std::clock_t begin = std::clock();
  try {
    FlowFigures figures = flow_out(flow);
    figures.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return figures;
  } catch (const engine::OutOfRange&) {
    // Stopped by the validity check: a result, not an error.
  } catch (const SceneError&) {
    // Refused in advance: above the critical step, or that of lasting contacts.
  }
  return {};
}

}  // namespace

void find_effect_of_step_on_flow(const ExperimentOptions& options, results::ExperimentResult& result) {
  const std::vector<double> factors =
      options.quick ? std::vector<double>{1, 3, 4} : std::vector<double>{1, 2, 3, 4};
  results::ExperimentChart rate, slope;
  rate.name = "step_discharge";
  rate.title = "Discharge through a slit of 10 mm over the time step";
  rate.subtitle = std::string("Model D, d = ") + (options.quick ? "2.82" : "1.88") +
                  " mm; 1: the published step of 2 us at d = 0.47 mm in proportion to d";
  rate.note = "No point: refused at the start or stopped by the validity check.";
  rate.x = {.label = "Time step over the published one", .lower = 0, .upper = 5};
  rate.y = {.label = "Mass rate [kg/(m s)]", .lower = 0, .upper = 4};
  slope = rate;
  slope.name = "step_repose";
  slope.title = "Slope of the heap beside the slit";
  slope.y = {.label = "Slope [degrees]", .lower = 0, .upper = 45};
  for (std::uint64_t seed = 1; seed <= (options.quick ? 2U : 3U); ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    ExperimentSeries rates{.name = name, .x = factors, .y = {}}, slopes = rates;
    for (const double factor : factors) {
      const FlowFigures figures = figures_of({.diameter = options.quick ? 2.82e-3 : 1.88e-3,
                                              .fill = options.quick ? 15e-3 : 20e-3,
                                              .factor = factor,
                                              .seed = seed,
                                              .threads = options.threads});
      rates.y.push_back(figures.rate);
      slopes.y.push_back(figures.slope);
      const std::string which =
          " with " + std::to_string(std::lround(factor)) + " times the published step, " + name;
      result.limits.push_back({"discharge" + which, figures.rate, std::nan(""), "kg/(m s)", ""});
      result.limits.push_back({"slope" + which, figures.slope, std::nan(""), "degrees", ""});
      result.limits.push_back({"processor time" + which, figures.cpu_seconds, std::nan(""), "s", ""});
    }
    rate.series.push_back(rates);
    slope.series.push_back(slopes);
  }
  result.charts = {rate, slope};
}

}  // namespace diefill::process::laboratory
