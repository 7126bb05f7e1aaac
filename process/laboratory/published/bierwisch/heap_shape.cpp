#include "process/laboratory/published/bierwisch/heap_shape.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "process/measure/figures/line_fit.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kBeyond = 0.02, kFitted = 0.6, kPeak = 0.2;  // shares of grains, of columns

using Surface = std::vector<std::pair<double, double>>;  // x, height in m, from the toe up

FittedLine line_through(const Surface& surface, std::size_t from, std::size_t to) {
  std::vector<double> x, height;
  for (std::size_t k = from; k < to; ++k) {
    x.push_back(surface[k].first);
    height.push_back(surface[k].second);
  }
  return fit_line(x, height);
}

/// From the toe up, x counted toward the peak.
Surface surface_of(const std::vector<Eigen::Vector3d>& grains, double width) {
  std::map<long, double> top;
  for (const auto& grain : grains) {
    auto& highest = top.try_emplace(std::lround(grain.x() / width), grain.z()).first->second;
    highest = std::max(highest, grain.z());
  }
  Surface surface;
  for (const auto& [column, height] : top) surface.emplace_back(static_cast<double>(column) * width, height);
  return surface;
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
  const Surface surface = surface_of(grains, 2 * powder.grain_diameter);
  const std::size_t columns = surface.size();
  if (columns < 5) return {std::nan(""), std::nan("")};
  const auto share = [&](double of) {
    return static_cast<std::size_t>(std::lround(of * static_cast<double>(columns)));
  };
  const std::size_t outside = share(0.5 * (1 - kFitted)), highest = std::max<std::size_t>(1, share(kPeak));
  const FittedLine line = line_through(surface, outside, columns - outside);
  std::sort(along.begin(), along.end());
  const double last = along[static_cast<std::size_t>(kBeyond * static_cast<double>(along.size()))];
  const double foot = (from.z() - line.level) / line.slope;
  double lacking = 0;
  for (std::size_t k = columns - highest; k < columns; ++k)
    lacking += line.at(surface[k].first) - surface[k].second;
  return {foot - last, lacking / static_cast<double>(highest)};
}

}  // namespace diefill::process::laboratory
