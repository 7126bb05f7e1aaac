// Periodic boundaries along any axes: grains near a border have images beyond the other one.
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
  std::int8_t periods[3];  ///< from the owner to the image, along x, y and z
};

/// Periodic length (m) along each axis; nothing: no period.
using PeriodLengths = std::array<std::optional<double>, 3>;

/// A box centred on the origin, periodic with these lengths.
class PeriodicBox {
 public:
  PeriodicBox() = default;
  explicit PeriodicBox(const PeriodLengths& period) : period_(period) {}

  bool any() const { return period_[0] || period_[1] || period_[2]; }
  const PeriodLengths& period() const { return period_; }

  /// The point inside the box that stands for `point` (m).
  Eigen::Vector3d wrapped(Eigen::Vector3d point) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
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
    const std::int8_t x = along(0), y = along(1), z = along(2);
    const auto add = [&](std::int8_t over_x, std::int8_t over_y, std::int8_t over_z) {
      // Along an axis that is not left there is nothing beside the grain itself.
      if ((over_x | over_y | over_z) != 0) images.push_back({owner, {over_x, over_y, over_z}});
    };
    add(x, 0, 0);
    add(0, y, 0);
    if (x != 0 && y != 0) add(x, y, 0);
    if (z == 0) return;
    add(0, 0, z);
    if (x != 0) add(x, 0, z);
    if (y != 0) add(0, y, z);
    if (x != 0 && y != 0) add(x, y, z);
  }
  /// m, from an image's owner to the image.
  Vector3 shift(const GrainImage& image) const {
    return {image.periods[0] * period_[0].value_or(0), image.periods[1] * period_[1].value_or(0),
            image.periods[2] * period_[2].value_or(0)};
  }

 private:
  PeriodLengths period_;
};

}  // namespace diefill::engine
