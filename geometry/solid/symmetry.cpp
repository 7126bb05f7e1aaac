#include "geometry/solid/symmetry.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry/mesh/triangle_tree.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxProbes = 2000;
constexpr int kLargestOrder = 60;
constexpr double kSameDirection = 1e-3;  // rad
constexpr double kBetterFit = 0.1;       // of a deviation: then another order is meant
constexpr double kShown = 5e-6;          // m, what two decimals of a millimetre show

/// Centroid and spread of a surface, by area.
struct Spread {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

Spread spread_of(std::span<const Corners> triangles) {
  Spread spread;
  double area = 0;
  for (const Corners& c : triangles) {
    const double weight = area_vector(c).norm();
    spread.centre += weight * (c[0] + c[1] + c[2]) / 3;
    area += weight;
  }
  spread.centre /= area;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Corners& c : triangles) {
    const double weight = area_vector(c).norm() / area;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : c) {
      const Eigen::Vector3d arm = corner - spread.centre;
      sum += arm;
      moments += weight / 12 * arm * arm.transpose();
    }
    moments += weight / 12 * sum * sum.transpose();
  }
  spread.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors();
  return spread;
}

/// Tests a solid with images of its own corners.
class Images {
 public:
  Images(const TriangleTree& tree, double tolerance)
      : tree_(tree), tolerance_(tolerance), spread_(spread_of(tree.triangles())) {
    const std::size_t stride = std::max<std::size_t>(1, tree_.triangles().size() / kMaxProbes);
    for (std::size_t t = 0; t < tree_.triangles().size(); t += stride) {
      // Corners of holes lie in the faces that the holes pierce; only the middles of walls show that a hole
      // is missing.
      const Corners& corners = tree_.corners(t);
      for (const auto& corner : corners) probes_.push_back(corner - spread_.centre);
      probes_.emplace_back((corners[0] + corners[1] + corners[2]) / 3 - spread_.centre);
    }
  }

  const Spread& spread() const { return spread_; }

  bool mirrored(const Eigen::Vector3d& normal) const {
    return deviation(Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose(), tolerance_) <= tolerance_;
  }

  /// 0: at every angle; 1: not at all. The circles of CAD files are polygons: where several orders fit, it is
  /// the largest that none fits much better.
  int order(const Eigen::Vector3d& axis) const {
    const auto when_turned = [&](double angle, double most) {
      return deviation(Eigen::AngleAxisd(angle, axis).toRotationMatrix(), most);
    };
    if (when_turned(1, tolerance_) <= tolerance_) return 0;  // one radian is no part of a turn
    int best = 1;
    double most = tolerance_;
    for (int n = kLargestOrder; n > 1; --n) {
      const double off = when_turned(2 * std::numbers::pi / n, most);
      if (off > most) continue;
      best = n;
      // Less is rounding.
      if (off <= kBetterFit * kBetterFit * tolerance_) break;
      most = kBetterFit * off;
    }
    return best;
  }

 private:
  /// m, largest distance of a mapped probe from the surface, or of the first that is farther than `most`.
  double deviation(const Eigen::Matrix3d& map, double most) const {
    double largest = 0;
    for (const Eigen::Vector3d& probe : probes_) {
      largest = std::max(largest, tree_.nearest(spread_.centre + map * probe).distance_squared);
      if (largest > most * most) break;
    }
    return std::sqrt(largest);
  }

  const TriangleTree& tree_;
  double tolerance_;
  Spread spread_;
  std::vector<Eigen::Vector3d> probes_;
};

bool along(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return one.cross(other).norm() < kSameDirection;
}

std::vector<Eigen::Vector3d> candidates(const Eigen::Matrix3d& principal) {
  std::vector<Eigen::Vector3d> directions = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitZ()};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = principal.col(k);
    const bool known = std::any_of(directions.begin(), directions.end(),
                                   [&](const Eigen::Vector3d& other) { return along(axis, other); });
    if (!known) directions.push_back(axis);
  }
  return directions;
}

std::string direction_text(const Eigen::Vector3d& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (along(direction, Eigen::Vector3d::Unit(axis))) return std::string(1, "xyz"[axis]);
  char text[60];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f)", direction[0], direction[1], direction[2]);
  return text;
}

}  // namespace

std::string Symmetry::description() const {
  std::string text;
  for (std::size_t k = 0; k < planes.size(); ++k)
    text += (k == 0                  ? (planes.size() == 1 ? "mirror plane across " : "mirror planes across ")
             : k + 1 < planes.size() ? ", "
                                     : " and ") +
            direction_text(planes[k]);
  for (const SymmetryAxis& axis : axes) {
    text += text.empty() ? "" : "; ";
    text += (axis.order == 0 ? "axisymmetric" : std::to_string(axis.order) + "-fold") + " about " +
            direction_text(axis.direction);
  }
  if (text.empty()) return "none found";
  char place[90];
  const auto shown = [&](int axis) { return std::abs(centre[axis]) < kShown ? 0.0 : 1e3 * centre[axis]; };
  std::snprintf(place, sizeof place, ", through (%.2f, %.2f, %.2f) mm", shown(0), shown(1), shown(2));
  return text + place;
}

Symmetry find_symmetry(const SolidQuery& solid, double tolerance) {
  Symmetry symmetry;
  const Images images(solid.tree(), tolerance);
  symmetry.centre = images.spread().centre;
  for (const Eigen::Vector3d& direction : candidates(images.spread().axes)) {
    if (images.mirrored(direction)) symmetry.planes.push_back(direction);
    const int order = images.order(direction);
    if (order != 1) symmetry.axes.push_back({direction, order});
  }
  return symmetry;
}

}  // namespace diefill::geometry
