#include "geometry/grids/distinct_points.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "geometry/grids/all_cores.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kSlabs = 256;
constexpr std::size_t kMaxAsHigh = 1000;  // points; more would take too long to compare with each other
constexpr double kRounding = 1e-12;       // of a height, in parts of the farthest coordinate

struct Height {
  double height;  ///< m, along the direction of the sweep
  std::uint32_t point;
};

/// Heights in rising order, sorted slab by slab on all cores.
std::vector<Height> in_order(const std::vector<double>& heights) {
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const double slab = std::max(*highest - *lowest, 1e-300) / kSlabs;
  const auto slab_of = [slab, low = *lowest](double height) {
    return std::min(kSlabs - 1, static_cast<std::size_t>((height - low) / slab));
  };
  std::vector<std::size_t> begin(kSlabs + 1, 0);
  for (const double height : heights) ++begin[slab_of(height) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Height> sorted(heights.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < heights.size(); ++i)
    sorted[next[slab_of(heights[i])]++] = {heights[i], static_cast<std::uint32_t>(i)};
  const auto at = [&](std::size_t place) { return sorted.begin() + static_cast<std::ptrdiff_t>(place); };
  on_all_cores(kSlabs, [&](std::size_t k) {
    std::sort(at(begin[k]), at(begin[k + 1]),
              [](const Height& a, const Height& b) { return a.height < b.height; });
  });
  return sorted;
}

}  // namespace

// Close points are about as high in any direction: each is compared with those above it that are not clearly
// higher.
bool surely_distinct(const std::vector<Eigen::Vector3d>& points, double distance) {
  if (points.size() < 2) return true;
  // Few faces of tools lie across this direction, so few points are equally high.
  const Eigen::Vector3d up = Eigen::Vector3d(0.5432109876, 0.3219876543, 0.7754321098).normalized();
  std::vector<double> heights(points.size());
  in_parts_on_all_cores(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) heights[i] = points[i].dot(up);
  });
  double farthest = 0;
  for (const Eigen::Vector3d& point : points) farthest = std::max(farthest, point.cwiseAbs().maxCoeff());
  const double as_high = distance + kRounding * farthest;
  const std::vector<Height> sorted = in_order(heights);
  std::atomic<bool> apart = true;
  in_parts_on_all_cores(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && apart.load(std::memory_order_relaxed); ++i)
      for (std::size_t j = i + 1; j < sorted.size() && sorted[j].height - sorted[i].height <= as_high; ++j)
        if (j - i > kMaxAsHigh || (points[sorted[i].point] - points[sorted[j].point]).norm() <= distance) {
          apart.store(false, std::memory_order_relaxed);
          break;
        }
  });
  return apart;
}

}  // namespace diefill::geometry
