#include "process/laboratory/published/sawing/groove_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::process::laboratory::sawing {
namespace {

using engine::RigidSetSpec;

constexpr double kLayers[] = {0.5 * kSpacing, 1.5 * kSpacing};  // depths of particles below a surface

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

/// The ingot's particles, and their places on the surface.
std::vector<Eigen::Vector3d> ingot_particles(const GrooveCase& one, std::vector<SurfacePlace>& surface) {
  std::vector<Eigen::Vector3d> places;
  const double radius = one.groove_radius, quarter = 0.5 * std::numbers::pi;
  const std::vector<double> rows = spread(-0.5 * one.length, 0.5 * one.length);
  // `area` of a whole row.
  const auto add = [&](double x, double z, double along, const Eigen::Vector3d& into, double area) {
    for (const double y : rows) {
      places.emplace_back(x, y, z);
      surface.push_back({along, into, area / static_cast<double>(rows.size())});
    }
  };
  for (const double depth : kLayers) {
    const double r = radius + depth, length = depth == kLayers[0] ? one.length : 0;
    const std::vector<double> arcs = spread(-quarter * r, quarter * r), heights = spread(0, one.top);
    for (const double arc : arcs) {
      const Eigen::Vector3d into(std::sin(arc / r), 0, -std::cos(arc / r));
      add(r * into.x(), r * into.z(), radius * arc / r, into,
          2 * quarter * radius * length / static_cast<double>(arcs.size()));
    }
    for (const double z : heights)
      for (const double side : {-1.0, 1.0})
        add(side * r, z, side * (radius * quarter + z), side * Eigen::Vector3d::UnitX(),
            one.top * length / static_cast<double>(heights.size()));
  }
  return places;
}

/// As wide as the ingot's layers: fluid would leave through the edges.
std::vector<Eigen::Vector3d> lid_particles(const GrooveCase& one) {
  std::vector<Eigen::Vector3d> places;
  const double half = one.groove_radius + 2 * kSpacing;
  for (const double depth : kLayers)
    for (const double x : spread(-half, half))
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

}  // namespace

RigidSetSpec wire_of(const GrooveCase& one) {
  RigidSetSpec wire = tool_of(wire_particles(one), kSteel);
  wire.centre = {0, 0, one.wire_start};
  wire.velocity = {0, one.speed, 0};
  wire.free = {false, false, one.pressure > 0};
  wire.drive = {0, 0, -one.pressure * 2 * one.wire_radius * one.length};
  // A wire is solid: its mass is that of all of its section.
  wire.shape.mass = kSteel * engine::laws::DpdParameters().density * std::numbers::pi * one.wire_radius *
                    one.wire_radius * one.length;
  return wire;
}

RigidSetSpec ingot_of(const GrooveCase& one, std::vector<SurfacePlace>& surface) {
  return tool_of(ingot_particles(one, surface), kGrainDensity);
}

RigidSetSpec lid_of(const GrooveCase& one) {
  return tool_of(lid_particles(one), kGrainDensity);
}

namespace {

double from_wire(const GrooveCase& one, const Eigen::Vector3d& place) {
  return std::hypot(place.x(), place.z() - one.wire_start) - one.wire_radius;
}

double from_rest(const GrooveCase& one, const Eigen::Vector3d& place) {
  const double from_middle = place.z() < 0 ? std::hypot(place.x(), place.z()) : std::abs(place.x());
  return std::min(one.groove_radius - from_middle, one.top - place.z());
}

}  // namespace

SlurrySpace space_of(const GrooveCase& one) {
  const double wide = one.groove_radius;
  const double area = 0.5 * std::numbers::pi * wide * wide + 2 * wide * one.top -
                      std::numbers::pi * one.wire_radius * one.wire_radius;
  return {
      {-wide, -0.5 * one.length, -wide},
      {wide, 0.5 * one.length, one.top},
      {std::nullopt, one.length, std::nullopt},
      area * one.length,
      [one](const Eigen::Vector3d& place) { return std::min(from_wire(one, place), from_rest(one, place)); },
      // Without slip at either: what it would become in the gap takes long to settle from rest.
      [one](const Eigen::Vector3d& place) -> Eigen::Vector3d {
        const double wire = from_wire(one, place), rest = from_rest(one, place);
        return {0, one.speed * rest / (wire + rest), 0};
      }};
}

}  // namespace diefill::process::laboratory::sawing
