#include "process/laboratory/published/sawing/groove.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "engine/fluid/fluid_figures.h"

namespace diefill::process::laboratory::sawing {
namespace {

using engine::FluidSimulation;
using engine::RigidSetSpec;

constexpr double kSteel = 6.5;  // density of the wire over that of the fluid: 7.8 over 1.2 g/cm^3
constexpr double kLayers[] = {0.5 * kSpacing, 1.5 * kSpacing};  // depths of particles below a surface
constexpr double kMostStretch = 2;                              // r_c, of the groove's surface
constexpr int kEvery = 5;                                       // steps between samples
constexpr int kGrainWindow = 100;  // steps over which the stress in a grain is taken

/// Numbers at equal distances of about kSpacing, half of one from both ends.
std::vector<double> spread(double from, double to) {
  const int count = std::max(1, static_cast<int>(std::lround((to - from) / kSpacing)));
  std::vector<double> places;
  for (int k = 0; k < count; ++k) places.push_back(from + (to - from) * (k + 0.5) / count);
  return places;
}

/// A tool of particles, which keeps its place and orientation.
RigidSetSpec tool_of(const std::vector<Eigen::Vector3d>& places, double density_over_fluid) {
  RigidSetSpec tool;
  tool.shape.sphere_radius = 0.5 * kSpacing;
  tool.shape.sphere_offsets = places;
  tool.shape.mass = particle_mass(density_over_fluid) * static_cast<double>(places.size());
  tool.tool = true;
  tool.turns = false;
  tool.free = {false, false, false};
  return tool;
}

/// A particle of the ingot: where along the surface it is, and the direction into the ingot.
struct SurfacePlace {
  double along;
  Eigen::Vector3d into;
};

/// The ingot's particles, and their places on the surface.
std::vector<Eigen::Vector3d> ingot_particles(const GrooveCase& one, std::vector<SurfacePlace>& surface) {
  std::vector<Eigen::Vector3d> places;
  const double radius = one.groove_radius, quarter = 0.5 * std::numbers::pi;
  const auto add = [&](double x, double z, double along, const Eigen::Vector3d& into) {
    for (const double y : spread(-0.5 * one.length, 0.5 * one.length)) {
      places.emplace_back(x, y, z);
      surface.push_back({along, into});
    }
  };
  for (const double depth : kLayers) {
    const double r = radius + depth;
    for (const double arc : spread(-quarter * r, quarter * r)) {
      const Eigen::Vector3d into(std::sin(arc / r), 0, -std::cos(arc / r));
      add(r * into.x(), r * into.z(), radius * arc / r, into);
    }
    for (const double z : spread(0, one.top))
      for (const double side : {-1.0, 1.0})
        add(side * r, z, side * (radius * quarter + z), side * Eigen::Vector3d::UnitX());
  }
  return places;
}

std::vector<Eigen::Vector3d> lid_particles(const GrooveCase& one) {
  std::vector<Eigen::Vector3d> places;
  for (const double depth : kLayers)
    for (const double x : spread(-one.groove_radius, one.groove_radius))
      for (const double y : spread(-0.5 * one.length, 0.5 * one.length))
        places.emplace_back(x, y, one.top + depth);
  return places;
}

/// The wire's particles about its axis.
std::vector<Eigen::Vector3d> wire_particles(const GrooveCase& one) {
  std::vector<Eigen::Vector3d> places;
  for (const double depth : kLayers) {
    const double r = one.wire_radius - depth;
    for (const double arc : spread(-std::numbers::pi * r, std::numbers::pi * r))
      for (const double y : spread(-0.5 * one.length, 0.5 * one.length))
        places.emplace_back(r * std::cos(arc / r), y, r * std::sin(arc / r));
  }
  return places;
}

SlurrySpace space_of(const GrooveCase& one) {
  const double wide = one.groove_radius;
  const double area = 0.5 * std::numbers::pi * wide * wide + 2 * wide * one.top -
                      std::numbers::pi * one.wire_radius * one.wire_radius;
  return {
      {-wide, -0.5 * one.length, -wide},
      {wide, 0.5 * one.length, one.top},
      {std::nullopt, one.length, std::nullopt},
      area * one.length,
      [one](const Eigen::Vector3d& place) {
        const double from_axis = std::hypot(place.x(), place.z() - one.wire_start);
        const double from_middle = place.z() < 0 ? std::hypot(place.x(), place.z()) : std::abs(place.x());
        return std::min({from_axis - one.wire_radius, one.groove_radius - from_middle, one.top - place.z()});
      }};
}

/// One run, and what it has found so far.
class Sawing {
 public:
  Sawing(const GrooveCase& one, std::uint64_t seed) : case_(one), simulation_(settings_of(one, seed)) {
    RigidSetSpec wire = tool_of(wire_particles(one), kSteel);
    wire.centre = {0, 0, one.wire_start};
    wire.velocity = {0, one.speed, 0};
    wire.free = {false, false, one.pressure > 0};
    wire.drive = {0, 0, -one.pressure * 2 * one.wire_radius * one.length};
    // A wire is solid: its mass is that of all of its section.
    wire.shape.mass = kSteel * settings_of(one, seed).law.density * std::numbers::pi * one.wire_radius *
                      one.wire_radius * one.length;
    wire_ = simulation_.add_solid(wire);
    first_of_ingot_ = simulation_.state().next_id;
    ingot_ = simulation_.add_solid(tool_of(ingot_particles(one, surface_), kGrainDensity));
    lid_ = simulation_.add_solid(tool_of(lid_particles(one), kGrainDensity));
    slurry_ = fill(space_of(one), {.solids = one.solids}, seed, simulation_);
    make_stretches();
  }

  GrooveFigures run() {
    const auto began = std::chrono::steady_clock::now();
    for (int k = 0; k < case_.settling; ++k) advance();
    for (int k = 1; k <= case_.sampled; ++k) {
      advance();
      add_grain_stress();
      if (k % kGrainWindow == 0) count_grain_stress();
      if (k % kEvery == 0) sample();
    }
    conclude();
    figures_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return figures_;
  }

 private:
  static engine::FluidSettings settings_of(const GrooveCase& one, std::uint64_t seed) {
    engine::FluidSettings settings;
    settings.period = {std::nullopt, one.length, std::nullopt};
    settings.seed = seed;
    settings.threads = all_threads();
    return settings;
  }

  void advance() {
    simulation_.step();
    figures_.particle_steps += static_cast<double>(simulation_.particles().size());
    if (simulation_.state().step % kEvery != 0) return;
    figures_.time.push_back(simulation_.time());
    figures_.distance.push_back(case_.groove_radius - case_.wire_radius +
                                simulation_.solids().motion()[wire_].centre.z());
  }

  void make_stretches() {
    const double half = case_.groove_radius * 0.5 * std::numbers::pi + case_.top;
    const int count = 2 * static_cast<int>(std::ceil(half / kMostStretch));
    for (int k = 0; k < count; ++k)
      figures_.stress.push_back({half * (2 * (k + 0.5) / count - 1), 2 * half / count, 0});
  }

  void sample() {
    ++samples_;
    const engine::Grains& particles = simulation_.particles();
    const double half = -(figures_.stress.front().place - 0.5 * figures_.stress.front().width);
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const std::uint32_t set = simulation_.solids().set_of(particles.id[k]);
      if (set == engine::RigidSets::kFluid) {
        add_speed(particles.position[k], particles.velocity[k].y());
      } else if (set == ingot_) {
        const SurfacePlace& at = surface_[particles.id[k] - first_of_ingot_];
        const auto stretch = static_cast<std::size_t>((at.along + half) / figures_.stress.front().width);
        figures_.stress[std::min(stretch, figures_.stress.size() - 1)].stress +=
            particles.force[k].dot(at.into);
      } else if (set == lid_) {
        lid_force_ += particles.force[k].z();
      }
    }
    figures_.temperature += engine::fluid_temperature(simulation_);
    figures_.mean_distance += figures_.distance.back();
  }

  /// Below the wire's axis, where groove and wire are round about one axis if the wire has not moved.
  void add_speed(const Eigen::Vector3d& place, double speed) {
    if (place.z() > 0) return;
    constexpr double kLayer = 0.25;
    const double from = case_.wire_radius, to = case_.groove_radius, r = std::hypot(place.x(), place.z());
    const auto layers = static_cast<std::size_t>(std::lround((to - from) / kLayer));
    speed_.resize(layers), count_.resize(layers);
    const double layer = (r - from) / (to - from) * static_cast<double>(layers);
    if (layer < 0 || layer >= static_cast<double>(layers)) return;
    speed_[static_cast<std::size_t>(layer)] += speed;
    count_[static_cast<std::size_t>(layer)] += 1;
  }

  void add_grain_stress() {
    if (slurry_.grain_size.empty()) return;
    const auto sums = engine::solid_pressure_times_volume(simulation_);
    grain_pressure_.resize(slurry_.grain_size.size());
    for (std::size_t g = 0; g < grain_pressure_.size(); ++g) {
      const std::size_t s = slurry_.first_grain + g;
      grain_pressure_[g] += sums[s].trace() / (3 * simulation_.solids().spec(s).shape.solid_volume);
    }
  }

  void count_grain_stress() {
    constexpr double kLow = 5, kHigh = 25;  // N/mm^2
    for (std::size_t g = 0; g < grain_pressure_.size(); ++g) {
      const double size = slurry_.grain_size[g];
      auto found = std::find_if(figures_.grains.begin(), figures_.grains.end(),
                                [&](const GrainStress& one) { return one.size == size; });
      if (found == figures_.grains.end()) found = figures_.grains.insert(found, GrainStress{.size = size});
      const double stress = ReducedUnits::pressure_of_process * grain_pressure_[g] / kGrainWindow;
      (stress <= kLow ? found->low : stress <= kHigh ? found->middle : found->high) += 1;
      grain_pressure_[g] = 0;
    }
  }

  /// A slice half a unit to either side of the middle.
  void take_section() {
    const engine::Grains& particles = simulation_.particles();
    using Part = SectionPoint::Part;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const Eigen::Vector3d& place = particles.position[k];
      if (std::abs(place.y()) > 0.5) continue;
      const std::uint32_t set = simulation_.solids().set_of(particles.id[k]);
      const Part part = set == engine::RigidSets::kFluid    ? Part::fluid
                        : simulation_.solids().is_tool(set) ? Part::tool
                                                            : Part::grain;
      figures_.section.push_back({part, place.x(), place.z()});
    }
  }

  void conclude() {
    take_section();
    const double width = case_.groove_radius - case_.wire_radius;
    for (std::size_t k = 0; k < speed_.size(); ++k)
      if (count_[k] > 0)
        figures_.gap.push_back(
            {case_.wire_radius + width * (static_cast<double>(k) + 0.5) / static_cast<double>(speed_.size()),
             speed_[k] / count_[k]});
    const double lid = lid_force_ / samples_ / (2 * case_.groove_radius * case_.length);
    for (GrooveStress& stretch : figures_.stress)
      stretch.stress = stretch.stress / samples_ / (stretch.width * case_.length) - lid;
    for (GrainStress& one : figures_.grains) {
      const double all = one.low + one.middle + one.high;
      one.low /= all, one.middle /= all, one.high /= all;
    }
    figures_.temperature /= samples_;
    figures_.mean_distance /= samples_;
    figures_.solids = slurry_.solids;
  }

  GrooveCase case_;
  FluidSimulation simulation_;
  std::size_t wire_ = 0, ingot_ = 0, lid_ = 0;
  std::uint64_t first_of_ingot_ = 0;
  std::vector<SurfacePlace> surface_;
  FilledSlurry slurry_;
  GrooveFigures figures_;
  double samples_ = 0, lid_force_ = 0;
  std::vector<double> speed_, count_;
  std::vector<double> grain_pressure_;
};

}  // namespace

GrooveFigures saw(const GrooveCase& one, std::uint64_t seed) {
  return Sawing(one, seed).run();
}

}  // namespace diefill::process::laboratory::sawing
