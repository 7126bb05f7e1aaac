#include "geometry/wall_spheres/wall_holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include "geometry/grids/cell_index.h"
#include "geometry/wall_spheres/wall_spheres.h"

namespace diefill::geometry {

namespace {

/// On a square grid the third of the nearest centres is nowhere farther than this, over the spacing.
constexpr double kThirdNearest = 1.12;
/// Guesses that differ by less, over the spacing, take the same path.
constexpr double kSameGuess = 1e-9;

[[noreturn]] void throw_too_thin(const Eigen::Vector3d& place, double thickness, double radius) {
  std::ostringstream text;
  text << std::setprecision(4) << "the solid is only " << 1e3 * thickness << " mm thick near ("
       << 1e3 * place.x() << ", " << 1e3 * place.y() << ", " << 1e3 * place.z()
       << ") mm, thinner than a wall sphere of " << 2e3 * radius << " mm diameter: thicken the part";
  throw ThinSolid(text.str(), thickness);
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

HoleFinder::HoleFinder(const WallLayout& layout, double step)
    : layout_(layout),
      step_(step),
      near_(layout.centres(), kThirdNearest * layout.spacing(), 2 * layout.spacing()) {}

bool HoleFinder::covered(const SurfaceSample& sample, double least) {
  const double near = least - step_;  // below 0 where centres lie closer than samples
  return near > 0 && near_.any_within(sample.at_depth(layout_.offset().depth()), near);
}

double HoleFinder::distance_to_nearest(const Eigen::Vector3d& place, double limit) {
  // Few have to be searched beyond a spacing.
  std::size_t nearest = near_.nearest_within(place, std::min(layout_.spacing(), limit));
  if (nearest == PointGrid::kNone) nearest = near_.nearest_within(place, limit);
  return nearest == PointGrid::kNone ? limit : (layout_.centres().points()[nearest] - place).norm();
}

Hole HoleFinder::find(const SurfaceSample& sample, const Eigen::Vector3d& place, double least) {
  const Hole hole{place, distance_to_nearest(place, limit())};
  if (hole.distance < least - step_) return {};
  const std::optional<Hole> between = hole_at(between_nearest(place), sample.point);
  if (!between || (between->middle - place).norm() > step_) return hole;
  return between->distance > hole.distance ? *between : hole;
}

// Where the solid is thinner than R, as at the tip of a wedge, the path starts from the middle of the solid.
std::optional<Eigen::Vector3d> HoleFinder::below(const SurfaceSample& sample) {
  const OffsetSurface& offset = layout_.offset();
  const Eigen::Vector3d guess = sample.at_depth(offset.depth());
  if (const auto place = offset.settle(guess, sample.point)) return place->centre;
  const double thickness = offset.thickness(sample.point, sample.normal);
  const Eigen::Vector3d inside = sample.point - thickness / 2 * sample.normal;
  if (const auto place = offset.settle(inside, sample.point)) return place->centre;
  if (const auto narrow = offset.thickness_between_opposite_faces(inside, sample.point))
    throw_too_thin(sample.point, *narrow, offset.depth());
  return std::nullopt;
}

std::optional<HoleFinder::Three> HoleFinder::three_nearest(const Eigen::Vector3d& place, double radius) {
  std::array<std::pair<double, std::size_t>, 3> nearest;
  nearest.fill({std::numeric_limits<double>::infinity(), 0});
  near_.for_each_within(place, radius, [&](std::size_t index, double distance_squared) {
    const std::pair<double, std::size_t> item(distance_squared, index);
    if (item >= nearest[2]) return;
    nearest[2] = item;
    if (nearest[2] < nearest[1]) std::swap(nearest[1], nearest[2]);
    if (nearest[1] < nearest[0]) std::swap(nearest[0], nearest[1]);
  });
  if (!std::isfinite(nearest[2].first)) return std::nullopt;
  return Three{nearest[0].second, nearest[1].second, nearest[2].second};
}

Eigen::Vector3d HoleFinder::between_nearest(const Eigen::Vector3d& place) {
  std::optional<Three> three = three_nearest(place, kThirdNearest * layout_.spacing());
  if (!three) three = three_nearest(place, 2 * layout_.spacing());
  if (!three) return place;
  const auto& points = layout_.centres().points();
  const auto& [a, b, c] = *three;
  return circumcentre(points[a], points[b], points[c]).value_or(place);
}

/// The circle's centre lies off the surface at depth R where that is bent, so it is brought back there.
std::optional<Hole> HoleFinder::hole_at(const Eigen::Vector3d& guess, const Eigen::Vector3d& surface_point) {
  const Eigen::Vector3i cube = cube_of(guess / layout_.spacing());
  SettlePath& path = paths_.at(cube);
  if ((path.guess - guess).norm() > kSameGuess * layout_.spacing()) {
    path.guess = guess;
    path.trail.clear();
  }
  const auto place = layout_.offset().settle(guess, surface_point, path.trail);
  if (!place) return std::nullopt;
  return Hole{place->centre, distance_to_nearest(place->centre, limit())};
}

}  // namespace diefill::geometry
