// Periodic boundaries along x and y: grains near a border have images beyond the other one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace diefill::engine {

/// A box centred on the origin, periodic along x and/or y with the given lengths (m).
class PeriodicBox {
 public:
  PeriodicBox() = default;
  explicit PeriodicBox(const std::array<std::optional<double>, 2>& period) : period_(period) {}

  bool any() const { return period_[0] || period_[1]; }
  const std::array<std::optional<double>, 2>& period() const { return period_; }

  /// The point inside the box that stands for `point` (m).
  Eigen::Vector3d wrapped(Eigen::Vector3d point) const {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (period_[axis]) {
        double& x = point[static_cast<Eigen::Index>(axis)];
        x -= *period_[axis] * std::floor(x / *period_[axis] + 0.5);
      }
    return point;
  }

  /// Appends the shifts (m) under which a point within `margin` (m) of a border is seen beyond the opposite
  /// one.
  void image_shifts(const Eigen::Vector3d& point, double margin, std::vector<Eigen::Vector3d>& shifts) const {
    const auto along = [&](std::size_t axis) -> double {
      if (!period_[axis]) return 0;
      const double x = point[static_cast<Eigen::Index>(axis)], half = 0.5 * *period_[axis];
      if (x < -half + margin) return *period_[axis];
      if (x > half - margin) return -*period_[axis];
      return 0;
    };
    const double x = along(0), y = along(1);
    if (x != 0) shifts.emplace_back(x, 0, 0);
    if (y != 0) shifts.emplace_back(0, y, 0);
    if (x != 0 && y != 0) shifts.emplace_back(x, y, 0);
  }

 private:
  std::array<std::optional<double>, 2> period_;
};

/// A grain's image beyond a periodic border: it moves with its owner and hands it all its forces.
struct GrainImage {
  std::uint32_t owner;
  Eigen::Vector3d shift;  ///< m
};

}  // namespace diefill::engine
