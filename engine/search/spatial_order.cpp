#include "engine/search/spatial_order.h"

#include <algorithm>
#include <bit>
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

using Keyed = std::pair<std::uint64_t, std::uint32_t>;

/// Sorts parts in parallel, then merges them two by two. No two keys are equal, so the order does not depend
/// on the parts.
void sort_in_parts(std::vector<Keyed>& keyed, ThreadPool& pool) {
  const std::size_t parts = std::bit_ceil(static_cast<std::size_t>(pool.threads()));
  const auto border = [&](std::size_t part) {
    return keyed.begin() + static_cast<std::ptrdiff_t>(keyed.size() * part / parts);
  };
  pool.for_each(parts, [&](std::size_t part) { std::sort(border(part), border(part + 1)); });
  for (std::size_t merged = 1; merged < parts; merged *= 2)
    pool.for_each(parts / (2 * merged), [&](std::size_t pair) {
      const std::size_t first = 2 * merged * pair;
      std::inplace_merge(border(first), border(first + merged), border(first + 2 * merged));
    });
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const std::vector<Eigen::Vector3d>& points, double cell,
                                         ThreadPool& pool) {
  Eigen::Vector3d origin = Eigen::Vector3d::Constant(1e300);
  for (const auto& point : points) origin = origin.cwiseMin(point);

  std::vector<Keyed> keyed(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Array3d place = ((points[k] - origin) / cell).array().min(2097151.0);
    const auto code = spread(static_cast<std::uint64_t>(place[0])) |
                      spread(static_cast<std::uint64_t>(place[1])) << 1 |
                      spread(static_cast<std::uint64_t>(place[2])) << 2;
    keyed[k] = {code, static_cast<std::uint32_t>(k)};
  }
  sort_in_parts(keyed, pool);
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = keyed[k].second;
  return order;
}

}  // namespace diefill::engine
