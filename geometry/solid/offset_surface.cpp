#include "geometry/solid/offset_surface.h"

#include <Eigen/QR>
#include <array>
#include <cmath>

namespace diefill::geometry {

namespace {

/// Depths agree with R when they differ by less than this part of it.
constexpr double kDepthTolerance = 1e-11;
constexpr std::size_t kSettleSteps = 40;
constexpr int kShrinkSteps = 60;
/// Two faces are one when the directions away from them differ by less than this.
constexpr double kSameDirection = 1e-3;

/// A face to move away from: `away` is the unit vector from it into the solid.
struct Constraint {
  Eigen::Vector3d foot;
  Eigen::Vector3d away;
};

/// The faces in the way, three at most: the newest replaces one of the same direction or the oldest.
class Constraints {
 public:
  void add(const Constraint& constraint) {
    for (std::size_t i = 0; i < count_; ++i)
      if ((list_[i].away - constraint.away).norm() < kSameDirection) {
        list_[i] = constraint;
        return;
      }
    if (count_ == list_.size()) {
      list_ = {list_[1], list_[2], constraint};
      return;
    }
    list_[count_++] = constraint;
  }

  /// The shortest move that brings `place` to `depth` below all faces. Leaves out the oldest where three have
  /// no such place, such as two facets of a curve and a face across; empty when two contradict each other.
  std::optional<Eigen::Vector3d> shortest_move(const Eigen::Vector3d& place, double depth) {
    const auto move = move_below_all(place, depth);
    if (move || count_ < 3) return move;
    list_ = {list_[1], list_[2], {}};
    count_ = 2;
    return move_below_all(place, depth);
  }

  /// Distance between the two most opposed faces, m.
  double distance_of_opposite_faces() const {
    double most_opposite = 0;
    double distance = 0;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double cosine = list_[i].away.dot(list_[j].away);
        if (cosine >= most_opposite) continue;
        most_opposite = cosine;
        distance = std::abs(list_[i].away.dot(list_[i].foot - list_[j].foot));
      }
    return distance;
  }

 private:
  std::optional<Eigen::Vector3d> move_below_all(const Eigen::Vector3d& place, double depth) const {
    const auto rows = static_cast<Eigen::Index>(count_);
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3> away(rows, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> missing(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Constraint& constraint = list_[static_cast<std::size_t>(i)];
      away.row(i) = constraint.away.transpose();
      missing[i] = depth - constraint.away.dot(place - constraint.foot);
    }
    if (rows == 1) return Eigen::Vector3d(missing[0] * list_[0].away);
    Eigen::CompleteOrthogonalDecomposition<decltype(away)> decomposition;
    decomposition.setThreshold(1e-6);
    decomposition.compute(away);
    const Eigen::Vector3d move = decomposition.solve(missing);
    if ((away * move - missing).cwiseAbs().maxCoeff() > 1e-6 * depth) return std::nullopt;
    return move;
  }

  std::array<Constraint, 3> list_;
  std::size_t count_ = 0;
};

}  // namespace

SolidQuery::Known OffsetSurface::nearest_at(const Eigen::Vector3d& place,
                                            const Eigen::Vector3d& near_boundary, std::size_t step,
                                            Trail* trail) const {
  if (trail != nullptr && step < trail->size()) return query_.signed_nearest(place, (*trail)[step]);
  const SolidQuery::Known nearest = query_.signed_nearest(place, (place - near_boundary).norm());
  if (trail != nullptr) trail->push_back(nearest);
  return nearest;
}

std::optional<OffsetSurface::Place> OffsetSurface::settle(const Eigen::Vector3d& guess,
                                                          Eigen::Vector3d near_boundary, double& thickness,
                                                          Trail* trail) const {
  Eigen::Vector3d place = guess;
  Constraints constraints;
  for (std::size_t step = 0; step < kSettleSteps; ++step) {
    const SolidQuery::Known nearest = nearest_at(place, near_boundary, step, trail);
    near_boundary = nearest.point;
    // Moves may lead through the opposite face of a wedge; the guess itself has to be inside.
    if ((step == 0 && !nearest.inside) || nearest.distance == 0) return std::nullopt;
    const double depth = nearest.inside ? nearest.distance : -nearest.distance;
    const Eigen::Vector3d away = (place - nearest.point) / depth;
    if (depth > depth_ * (1 + kDepthTolerance)) return Place{nearest.point + depth_ * away, nearest.point};
    if (depth >= depth_ * (1 - kDepthTolerance)) return Place{place, nearest.point};
    constraints.add({nearest.point, away});
    const std::optional<Eigen::Vector3d> move = constraints.shortest_move(place, depth_);
    if (!move) {
      thickness = constraints.distance_of_opposite_faces();
      return std::nullopt;
    }
    place += *move;
    if ((place - guess).norm() > kFarthestMove * depth_) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> OffsetSurface::thickness_between_opposite_faces(
    const Eigen::Vector3d& guess, const Eigen::Vector3d& near_boundary) const {
  double thickness = 0;
  if (settle(guess, near_boundary, thickness, nullptr) || thickness == 0) return std::nullopt;
  return thickness;
}

bool OffsetSurface::is_deep_enough(const Eigen::Vector3d& place) const {
  return query_.signed_distance(place) <= -depth_ * (1 - kDepthTolerance);
}

double OffsetSurface::thickness(const Eigen::Vector3d& surface_point,
                                const Eigen::Vector3d& outward_normal) const {
  double radius = depth_;
  for (int step = 0; step < kShrinkSteps; ++step) {
    const SolidQuery::Nearest nearest = query_.nearest(surface_point - radius * outward_normal);
    if (nearest.distance >= radius * (1 - kDepthTolerance)) break;
    const Eigen::Vector3d across = surface_point - nearest.point;
    const double depth_of_touch = across.dot(outward_normal);
    if (depth_of_touch <= 0) break;
    radius = across.squaredNorm() / (2 * depth_of_touch);
  }
  return 2 * radius;
}

}  // namespace diefill::geometry
