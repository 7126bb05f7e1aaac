#include "engine/spatial_order.h"

#include <algorithm>
#include <numeric>

namespace diefill::engine {

namespace {

/// Spreads the low 21 bits of `value` so that two zero bits follow each.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  value = (value | value << 2) & 0x1249249249249249;
  return value;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const std::vector<Eigen::Vector3d>& points, double cell) {
  Eigen::Vector3d origin = Eigen::Vector3d::Constant(1e300);
  for (const auto& point : points) origin = origin.cwiseMin(point);

  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Array3d place = ((points[k] - origin) / cell).array().min(2097151.0);
    const auto code = spread(static_cast<std::uint64_t>(place[0])) |
                      spread(static_cast<std::uint64_t>(place[1])) << 1 |
                      spread(static_cast<std::uint64_t>(place[2])) << 2;
    keyed[k] = {code, static_cast<std::uint32_t>(k)};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = keyed[k].second;
  return order;
}

}  // namespace diefill::engine
