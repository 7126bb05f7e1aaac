#include "geometry/wall_holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>

namespace diefill::geometry {

namespace {

[[noreturn]] void throw_too_thin(const Eigen::Vector3d& place, double thickness, double radius) {
  std::ostringstream text;
  text << std::setprecision(4) << "the solid is only " << 1e3 * thickness << " mm thick near ("
       << 1e3 * place.x() << ", " << 1e3 * place.y() << ", " << 1e3 * place.z()
       << ") mm, thinner than a wall sphere of " << 2e3 * radius
       << " mm diameter: make sphere_radius smaller than " << 0.5e3 * thickness << " mm or the part thicker";
  throw MeshError(text.str());
}

/// Centre of the circle through three points, or nothing when they lie in a line.
std::optional<Eigen::Vector3d> circumcentre(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                            const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d normal = u.cross(v);
  const double normal_squared = normal.squaredNorm();
  if (normal_squared < 1e-12 * u.squaredNorm() * v.squaredNorm()) return std::nullopt;
  return a + (normal.cross(u) * v.squaredNorm() + v.cross(normal) * u.squaredNorm()) / (2 * normal_squared);
}

}  // namespace

bool HoleFinder::covered(const SurfaceSample& sample, double least) const {
  const double near = least - step_;  // below 0 where centres lie closer than samples
  return near > 0 && layout_.centres().any_within(sample.at_depth(layout_.offset().depth()), near);
}

Hole HoleFinder::find(const Eigen::Vector3d& place, double least) const {
  const Hole hole{place, layout_.distance_to_nearest(place, limit())};
  if (hole.distance < least - step_) return {};
  // The circle's centre lies off the surface at depth R where that is bent, so it is brought back there.
  const auto between = layout_.offset().settle(between_nearest_centres(place));
  if (!between || (between->centre - place).norm() > step_) return hole;
  const double distance = layout_.distance_to_nearest(between->centre, limit());
  return distance > hole.distance ? Hole{between->centre, distance} : hole;
}

// Where the solid is thinner than R, as at the tip of a wedge, the way starts from the middle of the solid.
Eigen::Vector3d HoleFinder::below(const SurfaceSample& sample) const {
  const OffsetSurface& offset = layout_.offset();
  const Eigen::Vector3d guess = sample.at_depth(offset.depth());
  if (const auto place = offset.settle(guess)) return place->centre;
  const double thickness = offset.thickness(sample.point, sample.normal);
  const Eigen::Vector3d inside = sample.point - thickness / 2 * sample.normal;
  if (const auto place = offset.settle(inside)) return place->centre;
  if (const auto narrow = offset.thickness_between_opposite_faces(inside))
    throw_too_thin(sample.point, *narrow, offset.depth());
  return guess;
}

Eigen::Vector3d HoleFinder::between_nearest_centres(const Eigen::Vector3d& place) const {
  const auto& points = layout_.centres().points();
  std::array<std::pair<double, std::size_t>, 3> nearest;
  nearest.fill({std::numeric_limits<double>::infinity(), 0});
  layout_.centres().for_each_within(place, 2 * layout_.spacing(), [&](std::size_t index) {
    const std::pair<double, std::size_t> item((points[index] - place).squaredNorm(), index);
    if (item >= nearest[2]) return;
    nearest[2] = item;
    std::sort(nearest.begin(), nearest.end());
  });
  if (!std::isfinite(nearest[2].first)) return place;
  return circumcentre(points[nearest[0].second], points[nearest[1].second], points[nearest[2].second])
      .value_or(place);
}

}  // namespace diefill::geometry
