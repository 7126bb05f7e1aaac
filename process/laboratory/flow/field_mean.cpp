#include "process/laboratory/flow/field_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::process::laboratory {

FieldMean::FieldMean(const continuum::HopperGrid& grid, double averaging_width, bool odd)
    : grid_(grid), width_(averaging_width), odd_(odd) {
  const std::size_t nodes = static_cast<std::size_t>(grid.rows + 1) * grid.columns;
  sum_.assign(nodes, 0);
  weight_.assign(nodes, 0);
}

void FieldMean::add(double x, double z, double value) {
  add_one(x, z, value);
  add_one(-x, z, odd_ ? -value : value);
}

void FieldMean::add_one(double x, double z, double value) {
  const double reach = 3 * width_, dx = grid_.spacing_x(), dz = grid_.spacing_z();
  const auto first = [](double at) { return std::max(0, static_cast<int>(std::ceil(at))); };
  const int left = first((x - reach + grid_.width / 2) / dx - 0.5), low = first((z - reach) / dz);
  const int right =
      std::min(grid_.columns - 1, static_cast<int>(std::floor((x + reach + grid_.width / 2) / dx - 0.5)));
  const int high = std::min(grid_.rows, static_cast<int>(std::floor((z + reach) / dz)));
  if (right < left || high < low) return;
  std::vector<double> along(right - left + 1);
  for (int c = left; c <= right; ++c) {
    const double away = (grid_.x(c) - x) / width_;
    along[c - left] = std::exp(-0.5 * away * away);
  }
  for (int k = low; k <= high; ++k) {
    const double away = (k * dz - z) / width_;
    const double upright = std::exp(-0.5 * away * away);
    const std::size_t row = static_cast<std::size_t>(k) * grid_.columns;
    for (int c = left; c <= right; ++c) {
      const double weight = upright * along[c - left];
      weight_[row + c] += weight;
      sum_[row + c] += weight * value;
    }
  }
}

std::vector<double> FieldMean::mean() const {
  constexpr double kMin = 1e-3;
  const double most = *std::max_element(weight_.begin(), weight_.end());
  std::vector<double> means(sum_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < means.size(); ++k)
    if (weight_[k] > kMin * most) means[k] = sum_[k] / weight_[k];
  return means;
}

}  // namespace diefill::process::laboratory
