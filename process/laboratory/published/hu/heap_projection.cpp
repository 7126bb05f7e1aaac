#include "process/laboratory/published/hu/heap_projection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace diefill::process::laboratory {
namespace {

constexpr double kPixelsOverDiameter = 20;

/// Pixels of a picture of the heap, one row of empty ones all round but below.
class Picture {
 public:
  Picture(double left, double right, double top, double pixel)
      : left_(left - pixel),
        pixel_(pixel),
        columns_(static_cast<std::size_t>(std::ceil((right - left) / pixel)) + 2),
        rows_(static_cast<std::size_t>(std::ceil(top / pixel)) + 1),
        full_(columns_ * rows_, 0) {}

  void add_disc(double across, double height, double radius) {
    const auto first = [&](double from) { return static_cast<std::size_t>(std::max(0.0, std::floor(from))); };
    const std::size_t from_column = first((across - radius - left_) / pixel_),
                      from_row = first((height - radius) / pixel_);
    for (std::size_t row = from_row; row < rows_; ++row) {
      const double dz = (static_cast<double>(row) + 0.5) * pixel_ - height;
      if (dz > radius) break;
      for (std::size_t column = from_column; column < columns_; ++column) {
        const double dx = left_ + (static_cast<double>(column) + 0.5) * pixel_ - across;
        if (dx > radius) break;
        if (dx * dx + dz * dz <= radius * radius) full_[row * columns_ + column] = 1;
      }
    }
  }

  /// m^2, all that cannot be reached from above or the sides through empty pixels.
  double area() const {
    std::vector<std::uint8_t> outside = full_;  // 0: not reached yet
    std::vector<std::size_t> open;
    const auto reach = [&](std::size_t place) {
      if (outside[place] != 0) return;
      outside[place] = 2;
      open.push_back(place);
    };
    for (std::size_t row = 0; row < rows_; ++row) reach(row * columns_), reach((row + 1) * columns_ - 1);
    for (std::size_t column = 0; column < columns_; ++column) reach((rows_ - 1) * columns_ + column);
    while (!open.empty()) {
      const std::size_t place = open.back(), row = place / columns_, column = place % columns_;
      open.pop_back();
      if (row > 0) reach(place - columns_);
      if (row + 1 < rows_) reach(place + columns_);
      if (column > 0) reach(place - 1);
      if (column + 1 < columns_) reach(place + 1);
    }
    const auto out = std::count(outside.begin(), outside.end(), std::uint8_t{2});
    return static_cast<double>(outside.size() - static_cast<std::size_t>(out)) * pixel_ * pixel_;
  }

 private:
  double left_, pixel_;
  std::size_t columns_, rows_;
  std::vector<std::uint8_t> full_;
};

}  // namespace

double projected_area(const results::PowderState& powder, int axis) {
  if (powder.position.empty()) return 0;
  double left = 0, right = 0, top = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const double radius = powder.sphere_radius_of(k), across = powder.position[k][axis];
    left = std::min(left, across - radius);
    right = std::max(right, across + radius);
    top = std::max(top, powder.position[k][2] + radius);
  }
  Picture picture(left, right, top, powder.grain_diameter / kPixelsOverDiameter);
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    picture.add_disc(powder.position[k][axis], powder.position[k][2], powder.sphere_radius_of(k));
  return picture.area();
}

double area_equivalent_angle(const results::PowderState& powder, double plate) {
  const double base = plate + powder.grain_diameter;
  double sum = 0;
  for (const int axis : {0, 1}) sum += std::atan(4 * projected_area(powder, axis) / (base * base));
  return 0.5 * sum * 180 / std::numbers::pi;
}

int carr_class(double angle) {
  int number = 0;
  for (const double limit : {30.0, 38.0, 45.0, 55.0}) number += angle >= limit ? 1 : 0;
  return number;
}

}  // namespace diefill::process::laboratory
