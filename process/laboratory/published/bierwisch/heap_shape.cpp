#include "process/laboratory/published/bierwisch/heap_shape.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/simulation/standard_gravity.h"
#include "process/measure/figures/heap_slope.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kBeyond = 0.02, kPeak = 0.2;          // shares of grains, of columns
constexpr double kLeast = 2;                           // d above the floor, where the slope begins
constexpr double kGravity = engine::kStandardGravity;  // m/s^2

/// Highest grain centre (m) in each column.
std::map<long, double> tops_of(const std::vector<Eigen::Vector3d>& grains, double width) {
  std::map<long, double> top;
  for (const auto& grain : grains) {
    auto& highest = top.try_emplace(std::lround(grain.x() / width), grain.z()).first->second;
    highest = std::max(highest, grain.z());
  }
  return top;
}

/// From the toe up, x counted toward the peak.
HeapSurface peak_columns(const std::vector<Eigen::Vector3d>& grains, double width) {
  HeapSurface surface;
  for (const auto& [column, height] : tops_of(grains, width))
    surface.emplace_back(static_cast<double>(column) * width, height);
  return surface;
}

std::map<long, double> resting_tops(const results::PowderState& powder, const Eigen::AlignedBox3d& heap) {
  const double fastest = std::sqrt(2 * kGravity * powder.grain_diameter);
  std::vector<Eigen::Vector3d> grains;
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    if (heap.contains(powder.position[k]) && powder.velocity[k].norm() < fastest)
      grains.push_back(powder.position[k]);
  return tops_of(grains, 2 * powder.grain_diameter);
}

}  // namespace

HeapShape heap_shape(const results::PowderState& powder, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, bool rises) {
  std::vector<Eigen::Vector3d> grains;
  std::vector<double> along;
  for (const auto& place : powder.position) {
    if ((place.array() < from.array()).any() || (place.array() > to.array()).any()) continue;
    grains.emplace_back(rises ? place.x() : -place.x(), place.y(), place.z());
    along.push_back(grains.back().x());
  }
  const HeapSurface surface = peak_columns(grains, 2 * powder.grain_diameter);
  const std::size_t columns = surface.size();
  if (columns < 5) return {std::nan(""), std::nan("")};
  const auto highest = static_cast<std::size_t>(std::lround(kPeak * static_cast<double>(columns)));
  const FittedLine line = line_of_slope(surface, from.z(), kLeast * powder.grain_diameter);
  std::sort(along.begin(), along.end());
  const double last = along[static_cast<std::size_t>(kBeyond * static_cast<double>(along.size()))];
  const double foot = (from.z() - line.level) / line.slope;
  double lacking = 0;
  for (std::size_t k = columns - highest; k < columns; ++k)
    lacking += line.at(surface[k].first) - surface[k].second;
  return {foot - last, lacking / static_cast<double>(highest)};
}

double surface_drift(const results::PowderState& before, const results::PowderState& after,
                     const std::vector<Eigen::AlignedBox3d>& heaps) {
  double sum = 0, count = 0;
  for (const auto& heap : heaps) {
    const auto first = resting_tops(before, heap);
    for (const auto& [column, height] : resting_tops(after, heap)) {
      const auto earlier = first.find(column);
      if (earlier == first.end()) continue;
      sum += std::abs(height - earlier->second);
      ++count;
    }
  }
  return count > 0 ? sum / count / before.grain_diameter / (after.time - before.time) : std::nan("");
}

}  // namespace diefill::process::laboratory
