// Periodic boundaries along x and y: grains near a border have images beyond the other one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/numerics/vector3.h"

namespace diefill::engine {

/// A grain's image beyond a periodic border: it moves with its owner and hands it all its forces.
struct GrainImage {
  std::uint32_t owner;
  std::int8_t periods[2];  ///< from the owner to the image, along x and y
};

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

  /// Appends the images of grain `owner` at `point` (m) that are seen beyond borders because it is within
  /// `margin` (m) of the opposite ones.
  void add_images(std::uint32_t owner, const Eigen::Vector3d& point, double margin,
                  std::vector<GrainImage>& images) const {
    const auto along = [&](std::size_t axis) -> std::int8_t {
      if (!period_[axis]) return 0;
      const double x = point[static_cast<Eigen::Index>(axis)], half = 0.5 * *period_[axis];
      if (x < -half + margin) return 1;
      if (x > half - margin) return -1;
      return 0;
    };
    const std::int8_t x = along(0), y = along(1);
    if (x != 0) images.push_back({owner, {x, 0}});
    if (y != 0) images.push_back({owner, {0, y}});
    if (x != 0 && y != 0) images.push_back({owner, {x, y}});
  }
  /// m, from an image's owner to the image.
  Vector3 shift(const GrainImage& image) const {
    return {image.periods[0] * period_[0].value_or(0), image.periods[1] * period_[1].value_or(0), 0};
  }

 private:
  std::array<std::optional<double>, 2> period_;
};

}  // namespace diefill::engine
