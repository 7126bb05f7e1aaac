#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/fields/powder_places.h"
#include "process/measure/fields/ring_sample.h"
#include "process/measure/measure.h"
#include "process/measure/tool_solids.h"
#include "process/results/places_without_value.h"

namespace diefill::process {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr int kMaxHeights = 240;
constexpr double kMaxHeap = 0.25;  // of the cavity's depth: as much of a heap is on the map

/// Whole numbers of nodes round the circle, spaced by 2, 1 or 0.5 degrees: arcs no longer than 2 sigma if
/// possible.
std::vector<double> azimuth_nodes(double outer_radius, double averaging_width) {
  double step = 2;
  while (step > 0.5 && step * std::numbers::pi / 180 * outer_radius > 2 * averaging_width) step /= 2;
  const int intervals = static_cast<int>(std::lround(360 / step));
  std::vector<double> nodes;
  for (int i = 0; i <= intervals; ++i) nodes.push_back(i * step);
  return nodes;
}

/// Highest grain centre in the ring, m above the floor.
double highest_grain(const results::PowderState& powder, const results::CavityState& cavity) {
  double highest = 0;
  for (const auto& centre : powder.position) {
    const RingPosition place = ring_position(cavity, centre);
    if (place.radius >= cavity.inner_radius && place.radius <= cavity.outer_radius)
      highest = std::max(highest, place.height);
  }
  return highest;
}

/// mm from the floor to the fill plane, a node on each, and on to the top of a heap; about sigma / 2 apart.
std::vector<double> height_nodes(double depth, double highest, double averaging_width) {
  const int intervals =
      std::clamp(static_cast<int>(std::ceil(depth / (0.5 * averaging_width))), 1, kMaxHeights);
  const double step = depth / intervals;
  const double heap = std::clamp(highest - depth, 0.0, kMaxHeap * depth);
  const int beyond = static_cast<int>(std::ceil(heap / step));
  std::vector<double> nodes;
  for (int j = 0; j <= intervals + beyond; ++j) nodes.push_back(j * step / kMillimetre);
  return nodes;
}

/// Midpoints of equal slices of the ring's width, about sigma thick.
std::vector<double> radii(const results::CavityState& cavity, double averaging_width) {
  const double width = cavity.outer_radius - cavity.inner_radius;
  const int slices = std::clamp(static_cast<int>(std::ceil(width / averaging_width)), 3, 12);
  std::vector<double> middle;
  for (int n = 0; n < slices; ++n) middle.push_back(cavity.inner_radius + (n + 0.5) / slices * width);
  return middle;
}

/// Of the radii those that are outside all tools at a height (m above the floor): walls of a ring are the
/// same all round, so that one azimuth tells, and above the fill plane there are none.
std::vector<double> free_radii(const std::vector<geometry::SolidQuery>& solids,
                               const results::CavityState& cavity, const std::vector<double>& radius,
                               double height, double averaging_width) {
  const double skin = 0.05 * averaging_width;  // floor and ledges themselves are not inside
  if (height > cavity.upper_corner.z() - cavity.lower_corner.z()) return radius;
  std::vector<double> free;
  for (const double r : radius) {
    const Eigen::Vector3d point = ring_point(cavity, {0, r, height});
    if (std::ranges::none_of(solids, [&](const auto& solid) { return solid.signed_distance(point) < -skin; }))
      free.push_back(r);
  }
  return free;
}

/// Mean over the radii that find powder, weighted by radius as areas are.
double radial_mean(const PlaneValue& value_at, const results::CavityState& cavity,
                   const std::vector<double>& radius, double azimuth, double height) {
  double weights = 0, sum = 0;
  for (const double r : radius) {
    const double value = value_at(ring_point(cavity, {azimuth, r, height}));
    if (std::isnan(value)) continue;
    weights += r;
    sum += r * value;
  }
  return weights > 0 ? sum / weights : results::unvalued_powder();
}

/// 1 for the nodes that hold powder at any of the radii, in the powder's outline over azimuth and height.
std::vector<std::uint8_t> powder_nodes(const results::PowderState& powder, const results::CavityState& cavity,
                                       const results::Field2D& map, const std::vector<double>& radius,
                                       const std::vector<std::vector<double>>& free) {
  const PowderPlaces places(powder);
  std::vector<std::uint8_t> near;
  for (std::size_t j = 0; j < map.second.size(); ++j)
    for (const double azimuth : map.first)
      near.push_back(std::ranges::any_of(radius, [&](double r) {
        return places.near(ring_point(cavity, {azimuth, r, map.second[j] * kMillimetre}));
      }));
  const double arc = 0.5 * (cavity.inner_radius + cavity.outer_radius) * std::numbers::pi / 180;
  erode_edges(near,
              {map.first.size(), map.second.size(), arc * (map.first[1] - map.first[0]),
               kMillimetre * (map.second[1] - map.second[0]), true},
              outline_depth(places), [&](std::size_t, std::size_t j) { return free[j].empty(); });
  return near;
}

}  // namespace

results::Field2D sample_ring(const results::PowderState& powder, const std::vector<results::ToolState>& tools,
                             const results::CavityState& cavity, double averaging_width,
                             const PlaneValue& value_at) {
  const double depth = cavity.upper_corner.z() - cavity.lower_corner.z();
  if (!cavity.is_ring || !(depth > 0) || !(cavity.outer_radius > cavity.inner_radius))
    throw std::invalid_argument("a cylindrical map needs a ring with a depth and two radii");
  const std::vector<double> radius = radii(cavity, averaging_width);
  results::Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", {}, {}, {}, averaging_width};
  map.first = azimuth_nodes(cavity.outer_radius, averaging_width);
  map.second = height_nodes(depth, highest_grain(powder, cavity), averaging_width);
  map.value.reserve(map.first.size() * map.second.size());
  const std::vector<geometry::SolidQuery> solids = solids_of(tools);
  std::vector<std::vector<double>> free;
  for (const double height : map.second)
    free.push_back(free_radii(solids, cavity, radius, height * kMillimetre, averaging_width));
  const std::vector<std::uint8_t> is_powder = powder_nodes(powder, cavity, map, radius, free);
  for (std::size_t j = 0; j < map.second.size(); ++j) {
    const std::size_t row = map.value.size();
    for (std::size_t i = 0; i + 1 < map.first.size(); ++i)
      map.value.push_back(free[j].empty()           ? results::inside_tool()
                          : is_powder[row + i] != 0 ? radial_mean(value_at, cavity, free[j], map.first[i],
                                                                  map.second[j] * kMillimetre)
                                                    : std::numeric_limits<double>::quiet_NaN());
    map.value.push_back(map.value[row]);  // 360 degrees is 0 degrees
  }
  return map;
}

results::Field2D cylindrical_map(const results::PowderState& powder,
                                 const results::GrainSolidFraction& fraction,
                                 const std::vector<results::ToolState>& tools,
                                 const results::CavityState& cavity, double averaging_width) {
  const GaussianField field(powder, fraction, averaging_width);
  return sample_ring(powder, tools, cavity, averaging_width,
                     [&field](const Eigen::Vector3d& point) { return field.mean_at(point); });
}

}  // namespace diefill::process
