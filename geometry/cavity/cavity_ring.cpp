#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/cavity/cavity_shape.h"

namespace diefill::geometry {
namespace {

constexpr int kSectors = 24;  // all of them must show both walls

// Least squares for |p|^2 = 2 p.c + s, linear in centre c and s (Kasa): exact for points on a circle.
Eigen::Vector2d circle_centre(const std::vector<Eigen::Vector2d>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd right(matrix.rows());
  const Eigen::Vector2d shift = points.front();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::Vector2d point = points[static_cast<std::size_t>(i)] - shift;
    matrix.row(i) << 2 * point.x(), 2 * point.y(), 1;
    right[i] = point.squaredNorm();
  }
  const Eigen::Vector3d solution = matrix.colPivHouseholderQr().solve(right);
  return shift + solution.head<2>();
}

// Points of one wall as seen from the axis.
struct Circle {
  double smallest = 1e300, largest = -1e300, weighted_sum = 0, weight = 0;
  std::array<bool, kSectors> sectors{};

  void include(const Eigen::Vector2d& from_axis, double point_weight) {
    const double radius = from_axis.norm();
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
    weighted_sum += radius * point_weight;
    weight += point_weight;
    const double turn = std::atan2(from_axis.y(), from_axis.x()) / (2 * std::numbers::pi) + 0.5;
    sectors[static_cast<std::size_t>(std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1))] = true;
  }
  double radius() const { return weighted_sum / weight; }
  bool round(double tolerance) const {
    return weight > 0 && largest - smallest <= tolerance &&
           std::all_of(sectors.begin(), sectors.end(), [](bool seen) { return seen; });
  }
};

double middle_radius(const CavitySlice& slice, const Eigen::Vector2d& axis) {
  double smallest = 1e300, largest = 0;
  for (const auto& wall : slice.walls) {
    const double radius = (wall.middle() - axis).norm();
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
  }
  return (smallest + largest) / 2;
}

// The axis from the outer wall of the highest slice. Its walls' centre of mass is near enough to tell the
// walls apart.
Eigen::Vector2d find_axis(const CavitySlice& slice) {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double length = 0;
  for (const auto& wall : slice.walls) {
    centre += wall.middle() * wall.length();
    length += wall.length();
  }
  centre /= length;
  const double middle = middle_radius(slice, centre);
  std::vector<Eigen::Vector2d> outer;
  for (const auto& wall : slice.walls) {
    if ((wall.middle() - centre).norm() > middle) outer.push_back(wall.from);
  }
  return outer.size() < 3 ? centre : circle_centre(outer);
}

}  // namespace

std::optional<CavityRing> fit_ring(const std::vector<CavitySlice>& slices, double tolerance) {
  if (slices.empty()) return std::nullopt;
  CavityRing ring{find_axis(slices.back()), 1e300, 0, {1e300, {}}};
  for (const auto& slice : slices) {
    const double middle = middle_radius(slice, ring.axis);
    Circle inner, outer;
    for (const auto& wall : slice.walls) {
      auto& circle = (wall.middle() - ring.axis).norm() < middle ? inner : outer;
      for (const auto& point : {wall.from, wall.middle(), wall.to}) {
        circle.include(point - ring.axis, wall.length());
      }
    }
    if (!inner.round(tolerance) || !outer.round(tolerance)) return std::nullopt;
    const double width = outer.radius() - inner.radius();
    if (width <= 2 * tolerance) return std::nullopt;
    ring.inner_radius = std::min(ring.inner_radius, inner.radius());
    ring.outer_radius = std::max(ring.outer_radius, outer.radius());
    if (width < ring.narrowest.width) {
      const double radius = (inner.radius() + outer.radius()) / 2;
      ring.narrowest = {width, {ring.axis.x() + radius, ring.axis.y(), slice.height}};
    }
  }
  return ring;
}

}  // namespace diefill::geometry
