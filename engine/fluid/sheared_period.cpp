#include "engine/fluid/sheared_period.h"

#include <cmath>
#include <stdexcept>

namespace diefill::engine {

ShearedPeriod::ShearedPeriod(const PeriodLengths& period, double rate) : period_(period), rate_(rate) {
  if (rate == 0) return;
  if (!std::isfinite(rate) || !period[0] || !period[1])
    throw std::invalid_argument("a sheared box needs periods along x and y, and a finite rate");
  speed_ = rate * *period[1];
}

void ShearedPeriod::wrap(Grains& grains, double time) const {
  const double length_y = *period_[1];
  for (std::size_t k = 0; k < grains.size(); ++k) {
    Eigen::Vector3d& point = grains.position[k];
    // A point that rounding puts on the upper border goes on to the lower one.
    for (double over = std::floor(point.y() / length_y + 0.5); over != 0;
         over = std::floor(point.y() / length_y + 0.5)) {
      point.y() -= over * length_y;
      point.x() -= over * offset(time);
      grains.velocity[k].x() -= over * speed_;
    }
    for (const Eigen::Index axis : {Eigen::Index{0}, Eigen::Index{2}})
      if (const auto& period = period_[static_cast<std::size_t>(axis)])
        point[axis] -= *period * std::floor(point[axis] / *period + 0.5);
  }
}

Eigen::Vector3d ShearedPeriod::nearest(Eigen::Vector3d point, const Eigen::Vector3d& near, double time,
                                       Eigen::Vector3d& velocity) const {
  for (const Eigen::Index axis : {Eigen::Index{1}, Eigen::Index{2}, Eigen::Index{0}})
    if (const auto& period = period_[static_cast<std::size_t>(axis)]) {
      const double over = std::round((point[axis] - near[axis]) / *period);
      point[axis] -= over * *period;
      if (axis != 1 || !shears()) continue;
      point.x() -= over * offset(time);
      velocity.x() -= over * speed_;
    }
  return point;
}

PeriodicBox ShearedPeriod::searched() const {
  PeriodLengths seen = period_;
  if (shears()) seen[0] = *period_[0] / kPartsOfPeriod;
  return PeriodicBox(seen);
}

void ShearedPeriod::find_images(const std::vector<Eigen::Vector3d>& positions, double margin, double time,
                                std::vector<GrainImage>& images) {
  const double length_x = *period_[0];
  found_at_ = time;
  found_offset_ = offset(time) - length_x * std::round(offset(time) / length_x);
  over_x_.clear();
  // Beyond which borders a point is seen: along y and z, up, down or not at all.
  const auto beyond = [&](double x, const std::optional<double>& period) {
    if (!period) return 0;
    return x < -0.5 * *period + margin ? 1 : x > 0.5 * *period - margin ? -1 : 0;
  };
  for (std::uint32_t k = 0; k < positions.size(); ++k) {
    const Eigen::Vector3d& point = positions[k];
    const int y = beyond(point.y(), period_[1]), z = beyond(point.z(), period_[2]);
    add_row(k, point, margin, 0, 0, images);
    if (y != 0) add_row(k, point, margin, y, 0, images);
    if (z != 0) add_row(k, point, margin, 0, z, images);
    if (y != 0 && z != 0) add_row(k, point, margin, y, z, images);
  }
}

/// Images of one row along x: those that are in the box, or within `margin` of it.
void ShearedPeriod::add_row(std::uint32_t owner, const Eigen::Vector3d& point, double margin, int over_y,
                            int over_z, std::vector<GrainImage>& images) {
  const double length_x = *period_[0], displaced = over_y * found_offset_;
  for (int over_x = -1; over_x <= 1; ++over_x) {
    if (over_x == 0 && over_y == 0 && over_z == 0) continue;
    const double shift = over_x * length_x + displaced;
    if (std::abs(point.x() + shift) > 0.5 * length_x + margin) continue;
    images.push_back({owner,
                      {static_cast<std::int8_t>(std::lround(kPartsOfPeriod * shift / length_x)),
                       static_cast<std::int8_t>(over_y), static_cast<std::int8_t>(over_z)}});
    over_x_.push_back(static_cast<std::int8_t>(over_x));
  }
}

ShearedPeriod::Shift ShearedPeriod::shift(std::size_t k, const GrainImage& image, double time) const {
  const double over_y = image.periods[1];
  const double displaced = over_y * (found_offset_ + speed_ * (time - found_at_));
  return {
      {over_x_[k] * *period_[0] + displaced, over_y * *period_[1], image.periods[2] * period_[2].value_or(0)},
      {over_y * speed_, 0, 0}};
}

}  // namespace diefill::engine
