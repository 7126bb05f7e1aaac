#include "process/laboratory/flow/hopper_run.h"

#include <algorithm>
#include <cmath>

#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/endless_ground.h"
#include "process/laboratory/flow/field_mean.h"
#include "process/measure/measure.h"
#include "process/powder/material.h"
#include "process/results/none.h"
#include "process/run/fill_run.h"
#include "process/run/powder_state.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/tooling/rest.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kWallRadius = 1.5e-4;     // m, R_w (Bierwisch 2009, Table C.5)
constexpr double kWallSpacing = 1.6;       // over R_w
constexpr double kBelow = -20e-3;          // m, below which grains are taken out
constexpr double kGateSpeed = 5;           // m/s, at which the gate falls: far ahead of the powder
constexpr double kBurn = 0.1;              // s of flow on Earth before fields are taken
constexpr double kInterval = 5e-4;         // s between samples of velocity
constexpr int kFractionEvery = 8;          // samples to one of the solid fraction
constexpr double kGridSpacing = 5e-4;      // m
constexpr double kMeasuredHeight = 50e-3;  // m, of the grid
constexpr double kLongestSettling = 5;     // s

Scene scene_of(const HopperSetup& setup) {
  Scene scene;
  scene.seed = setup.seed;
  scene.powder = setup.powder;
  scene.gravity = {0, 0, -setup.gravity};
  scene.numerics.period[1] = setup.depth;
  scene.pour.lower = {-0.5 * setup.width, -0.5 * setup.depth, 0};
  scene.pour.upper = {0.5 * setup.width, 0.5 * setup.depth, setup.fill};
  scene.pour.fill_height = setup.fill;
  return scene;
}

/// Spheres of a plate from x = `from` to `to` (m), their tops at z = 0, repeating along y.
engine::WallBodySpec plate(const std::string& name, const HopperSetup& setup, double from, double to,
                           double margin) {
  engine::WallBodySpec body;
  body.name = name;
  body.sphere_radius = kWallRadius;
  const double wanted = kWallSpacing * kWallRadius;
  const double dy = setup.depth / std::ceil(setup.depth / wanted);
  const int ny = static_cast<int>(std::ceil((0.5 * setup.depth + margin) / dy));
  const int nx = std::max(1, static_cast<int>(std::ceil((to - from) / wanted)));
  for (int i = 0; i <= nx; ++i)
    for (int j = -ny; j <= ny; ++j)
      body.centres.emplace_back(from + (to - from) * i / nx, j * dy, -kWallRadius);
  return body;
}

/// Both side walls, flat and without end.
engine::WallBodySpec sides_of(const HopperSetup& setup) {
  engine::WallBodySpec body;
  body.name = "side walls";
  const Eigen::Vector3d right(0.5 * setup.width, 0, 0);
  body.planes = {{-right, Eigen::Vector3d::UnitX()}, {right, -Eigen::Vector3d::UnitX()}};
  return body;
}

/// Floor left and right of the slit, gate, side walls. The slit is measured between the spheres' surfaces.
std::vector<engine::WallBodySpec> walls_of(const HopperSetup& setup, double margin) {
  const double edge = 0.5 * setup.slit + kWallRadius, end = 0.5 * setup.width + margin;
  return {plate("left floor", setup, -end, -edge, margin), plate("right floor", setup, edge, end, margin),
          plate("gate", setup, -edge + 2 * kWallRadius, edge - 2 * kWallRadius, margin), sides_of(setup)};
}
constexpr std::size_t kGate = 2;

/// The walls as solid fractions see them: spheres, also on the sides.
std::vector<results::ToolState> tools_of(const HopperSetup& setup,
                                         const std::vector<engine::WallBodySpec>& walls, double margin) {
  std::vector<results::ToolState> tools;
  const auto add = [&](const engine::WallBodySpec& body) {
    results::ToolState tool;
    tool.name = body.name;
    tool.role = "plate";
    tool.wall_sphere_centres = body.centres;
    tool.wall_sphere_radius = body.sphere_radius;
    tools.push_back(tool);
  };
  for (std::size_t k = 0; k < kGate; ++k) add(walls[k]);
  engine::WallBodySpec sides;
  sides.name = "sides";
  sides.sphere_radius = kWallRadius;
  const double step = 4 * kWallRadius, x = 0.5 * setup.width + kWallRadius;
  for (double z = 0; z < setup.fill; z += step)
    for (double y = -0.5 * setup.depth - margin; y < 0.5 * setup.depth + margin; y += step)
      for (const double at : {-x, x}) sides.centres.emplace_back(at, y, z);
  add(sides);
  return tools;
}

void settle(engine::Simulation& simulation, double grain_diameter) {
  RestWatch rest;
  do {
    for (int n = 0; n < 50; ++n) simulation.step();
  } while (!rest.at_rest(simulation, grain_diameter) && simulation.time() < kLongestSettling);
}

void open_slit(engine::Simulation& simulation) {
  const double then = simulation.time();
  simulation.set_motion(kGate, [then](double time) {
    engine::BodyMotion motion;
    motion.translation = {0, 0, -kGateSpeed * std::max(0.0, time - then)};
    motion.velocity = {0, 0, time > then ? -kGateSpeed : 0};
    return motion;
  });
}

/// One flow, from the opening of the slit on.
class Flow {
 public:
  Flow(const HopperSetup& setup, engine::Simulation& simulation, std::vector<results::ToolState> tools)
      : setup_(setup),
        simulation_(simulation),
        tools_(std::move(tools)),
        grid_{setup.width, kMeasuredHeight, static_cast<int>(std::lround(setup.width / kGridSpacing)),
              static_cast<int>(std::lround(kMeasuredHeight / kGridSpacing))},
        vertical_(grid_, setup.averaging_width, false),
        horizontal_(grid_, setup.averaging_width, true),
        fraction_(grid_, setup.averaging_width, false),
        opened_(simulation.time()) {
    fields_.grid = grid_;
    fields_.grains = simulation.grains().size();
    const auto powder = state();
    fields_.bulk_fraction = bulk_solid_fraction(powder, measure_solid_fraction(powder, tools_, {}));
    volume_ = simulation.shape_of(0).solid_volume / (fields_.bulk_fraction * setup.depth);
    level_ = static_cast<double>(fields_.grains) * volume_ / setup.width;
    sunk_ = grains_below_slit(powder);
  }

  HopperFields run(const std::function<void(double)>& on_progress) {
    const double burn = kBurn * std::sqrt(engine::kStandardGravity / setup_.gravity);
    double began = kNone, out_before = kNone;
    while (level() > setup_.to && seconds() < 40 * burn) {
      advance(kInterval * std::sqrt(engine::kStandardGravity / setup_.gravity));
      fields_.time.push_back(seconds());
      fields_.discharged.push_back(discharged());
      on_progress(std::min(0.99, (level_ - level()) / (level_ - setup_.to)));
      if (seconds() < burn || level() > setup_.from) continue;
      if (std::isnan(began)) {
        began = seconds();
        out_before = discharged();
      }
      sample();
    }
    fields_.flowing_seconds = seconds() - began;
    fields_.outflow = (discharged() - out_before) / fields_.flowing_seconds;
    fields_.vertical = vertical_.mean();
    fields_.horizontal = horizontal_.mean();
    fields_.fraction = fraction_.mean();
    return fields_;
  }

 private:
  results::PowderState state() const {
    return powder_state(simulation_, simulation_.settings().shape(), setup_.powder.grain_diameter);
  }
  double seconds() const { return simulation_.time() - opened_; }
  /// m^2 of bulk powder that have passed z = 0.
  double discharged() const { return passed_ * volume_; }
  double level() const { return level_ - discharged() / setup_.width; }
  void advance(double time) {
    const double until = simulation_.time() + time;
    while (simulation_.time() < until) simulation_.step();
    simulation_.remove_grains([](const Eigen::Vector3d& place) { return place.z() < kBelow; });
    const auto taken_out = static_cast<double>(fields_.grains - simulation_.grains().size());
    passed_ = taken_out + grains_below_slit(state()) - sunk_;
  }
  void sample() {
    const auto powder = state();
    for (std::size_t k = 0; k < powder.position.size(); ++k) {
      const auto& place = powder.position[k];
      vertical_.add(place.x(), place.z(), powder.velocity[k].z());
      horizontal_.add(place.x(), place.z(), powder.velocity[k].x());
    }
    if (fields_.samples++ % kFractionEvery != 0) return;
    const auto fraction = measure_solid_fraction(powder, tools_, {});
    for (std::size_t k = 0; k < powder.position.size(); ++k)
      if (!fraction.open[k])
        fraction_.add(powder.position[k].x(), powder.position[k].z(), fraction.solid_fraction[k]);
  }

  const HopperSetup& setup_;
  engine::Simulation& simulation_;
  std::vector<results::ToolState> tools_;
  continuum::HopperGrid grid_;
  FieldMean vertical_, horizontal_, fraction_;
  double opened_, volume_ = 0, level_ = 0;
  double sunk_ = 0, passed_ = 0;  // grains: between the gate's spheres, and since the slit opened
  HopperFields fields_;
};

/// m^2/s, of those packings that have flowed; NaN where none has.
double mean_outflow(const std::vector<HopperFields>& packings) {
  double flowed = 0, mean = 0;
  for (const auto& one : packings) flowed += std::isfinite(one.outflow) ? 1 : 0;
  for (const auto& one : packings)
    if (std::isfinite(one.outflow)) mean += one.outflow / flowed;
  return flowed > 0 ? mean : kNone;
}

}  // namespace

double grains_below_slit(const results::PowderState& powder) {
  const auto centres = powder.sphere_centres();
  const auto radii = powder.radii_of_spheres();
  double below = 0, all = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    // A cap of height h of a sphere: pi h^2 (R - h / 3). The factor pi cancels.
    const double h = std::clamp(radii[k] - centres[k].z(), 0.0, 2 * radii[k]);
    below += h * h * (radii[k] - h / 3);
    all += 4.0 / 3 * radii[k] * radii[k] * radii[k];
  }
  return all > 0 ? below / all * static_cast<double>(powder.position.size()) : 0;
}

HopperFields run_hopper(const HopperSetup& setup, const std::function<void(double)>& on_progress) {
  const Scene scene = scene_of(setup);
  const double d = setup.powder.grain_diameter, margin = 4 * d;
  const double poured = pour_height(scene, engine_settings(scene, 1.0));
  auto settings = engine_settings(scene, expected_impact_speed(scene, poured));
  settings.threads = setup.threads;
  const auto walls = walls_of(setup, margin);
  engine::Simulation simulation(settings, walls);
  simulation.add_grains(pour(scene, settings, endless_ground(scene)));
  settle(simulation, d);
  Flow flow(setup, simulation, tools_of(setup, walls, margin));
  open_slit(simulation);
  return flow.run(on_progress);
}

HopperFields mean_of(const std::vector<HopperFields>& packings) {
  HopperFields mean = packings.front();
  const auto average = [&](std::vector<double> HopperFields::*field) {
    auto& values = mean.*field;
    for (std::size_t k = 0; k < values.size(); ++k) {
      double sum = 0, count = 0;
      for (const auto& one : packings)
        if (std::isfinite((one.*field)[k])) {
          sum += (one.*field)[k];
          ++count;
        }
      values[k] = count > 0 ? sum / count : kNone;
    }
  };
  average(&HopperFields::vertical);
  average(&HopperFields::horizontal);
  average(&HopperFields::fraction);
  for (const auto& one : packings) mean.time.resize(std::min(mean.time.size(), one.time.size()));
  mean.discharged.assign(mean.time.size(), 0.0);
  for (const auto& one : packings)
    for (std::size_t k = 0; k < mean.time.size(); ++k)
      mean.discharged[k] += one.discharged[k] / static_cast<double>(packings.size());
  mean.bulk_fraction = 0;
  for (const auto& one : packings)
    mean.bulk_fraction += one.bulk_fraction / static_cast<double>(packings.size());
  mean.outflow = mean_outflow(packings);
  return mean;
}

}  // namespace diefill::process::laboratory
