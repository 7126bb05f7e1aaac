#include "process/measure/cavity_position.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::process {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Horizontal unit vectors to azimuth 0 and 90 degrees.
struct RingAxes {
  Eigen::Vector3d zero, ninety;
};

RingAxes axes_of(const results::CavityState& cavity) {
  Eigen::Vector3d zero(cavity.azimuth_zero.x(), cavity.azimuth_zero.y(), 0);
  if (zero.norm() == 0) zero = Eigen::Vector3d::UnitX();
  zero.normalize();
  return {zero, Eigen::Vector3d(-zero.y(), zero.x(), 0)};
}

}  // namespace

bool lies_in_cavity(const results::CavityState& cavity, const Eigen::Vector3d& point) {
  if ((cavity.upper_corner.array() <= cavity.lower_corner.array()).any()) return false;
  const bool in_box = (point.array() >= cavity.lower_corner.array()).all() &&
                      (point.array() <= cavity.upper_corner.array()).all();
  if (!in_box || !cavity.is_ring) return in_box;
  const double radius = ring_position(cavity, point).radius;
  return radius >= cavity.inner_radius && radius <= cavity.outer_radius;
}

bool lies_in_any_cavity(const std::vector<results::CavityState>& cavities, const Eigen::Vector3d& point) {
  return std::any_of(cavities.begin(), cavities.end(),
                     [&](const results::CavityState& cavity) { return lies_in_cavity(cavity, point); });
}

std::vector<std::uint8_t> grains_in_cavity(const results::CavityState& cavity,
                                           const results::PowderState& powder) {
  std::vector<std::uint8_t> inside;
  inside.reserve(powder.position.size());
  for (const Eigen::Vector3d& centre : powder.position) inside.push_back(lies_in_cavity(cavity, centre));
  return inside;
}

RingPosition ring_position(const results::CavityState& cavity, const Eigen::Vector3d& point) {
  const RingAxes axes = axes_of(cavity);
  const Eigen::Vector3d from_axis = point - cavity.axis_origin;
  const double along = from_axis.dot(axes.zero), across = from_axis.dot(axes.ninety);
  double azimuth = kDegrees * std::atan2(across, along);
  if (azimuth < 0) azimuth += 360;
  if (azimuth >= 360) azimuth = 0;  // a tiny negative angle rounds up to 360
  return {azimuth, std::hypot(along, across), point.z() - cavity.lower_corner.z()};
}

Eigen::Vector3d ring_point(const results::CavityState& cavity, const RingPosition& position) {
  const RingAxes axes = axes_of(cavity);
  const double angle = position.azimuth / kDegrees;
  Eigen::Vector3d point =
      cavity.axis_origin + position.radius * (std::cos(angle) * axes.zero + std::sin(angle) * axes.ninety);
  point.z() = cavity.lower_corner.z() + position.height;
  return point;
}

double travel_length(const results::CavityState& cavity) {
  const Eigen::Vector3d size = cavity.upper_corner - cavity.lower_corner, zero = axes_of(cavity).zero;
  return std::abs(zero.x()) * size.x() + std::abs(zero.y()) * size.y();
}

double along_travel(const results::CavityState& cavity, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from_middle = point - 0.5 * (cavity.lower_corner + cavity.upper_corner);
  return 0.5 - from_middle.dot(axes_of(cavity).zero) / travel_length(cavity);
}

}  // namespace diefill::process
