#include "process/measure/figures/heap_slope.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace diefill::process {
namespace {

constexpr double kColumn = 2;                  // d
constexpr double kLeast = 2;                   // d above the floor, where the slope begins
constexpr double kToe = 0.2, kShoulder = 0.8;  // of the heap's height, ends of the slope
constexpr std::size_t kMin = 3;                // points that make a slope

/// Middles of columns and the highest grain centre in each, where there are grains.
HeapSurface surface_of(const results::PowderState& powder, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to) {
  const double width = kColumn * powder.grain_diameter;
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::ceil((to[0] - from[0]) / width)));
  constexpr double kEmpty = -std::numeric_limits<double>::infinity();
  std::vector<double> highest(columns, kEmpty);
  for (const Eigen::Vector3d& place : powder.position) {
    if ((place.array() < from.array()).any() || (place.array() > to.array()).any()) continue;
    const auto column = std::min(static_cast<std::size_t>((place[0] - from[0]) / width), columns - 1);
    highest[column] = std::max(highest[column], place[2]);
  }
  HeapSurface surface;
  for (std::size_t k = 0; k < columns; ++k)
    if (highest[k] > kEmpty)
      surface.emplace_back(from[0] + (static_cast<double>(k) + 0.5) * width, highest[k]);
  return surface;
}

FittedLine line_through(const HeapSurface& points) {
  std::vector<double> x, z;
  for (const auto& [place, height] : points) {
    x.push_back(place);
    z.push_back(height);
  }
  return fit_line(x, z);
}

/// Where the surface is at height `z`, between two of its points.
std::pair<double, double> crossing(const std::pair<double, double>& one,
                                   const std::pair<double, double>& other, double z) {
  const double share = (z - one.second) / (other.second - one.second);
  return {one.first + share * (other.first - one.first), z};
}

}  // namespace

FittedLine line_of_slope(HeapSurface surface, double floor, double least) {
  if (surface.empty()) return {};
  if (line_through(surface).slope < 0) std::reverse(surface.begin(), surface.end());  // from the toe up
  double height = 0;
  for (const auto& point : surface) height = std::max(height, point.second - floor);
  const double low = floor + std::max(least, kToe * height), high = floor + kShoulder * height;
  const auto top = std::find_if(surface.begin(), surface.end(),
                                [high](const auto& point) { return point.second >= high; });
  if (low >= high || top == surface.begin()) return {};
  auto foot = top;
  while (foot != surface.begin() && std::prev(foot)->second > low) --foot;
  HeapSurface slope(foot, top);
  if (foot != surface.begin()) slope.insert(slope.begin(), crossing(*std::prev(foot), *foot, low));
  slope.push_back(crossing(*std::prev(top), *top, high));
  return slope.size() < kMin ? FittedLine{} : line_through(slope);
}

double heap_slope(const results::PowderState& powder, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to) {
  const FittedLine line =
      line_of_slope(surface_of(powder, from, to), from[2], kLeast * powder.grain_diameter);
  return std::atan(std::abs(line.slope)) * 180 / std::numbers::pi;
}

std::string heap_figure(const std::string& name) {
  std::string key = "slope_of_";
  for (const char letter : name) key += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return key + "_deg";
}

}  // namespace diefill::process
