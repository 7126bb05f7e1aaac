#include "process/measure/volumes/partial_volumes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/volumes/grid_shares.h"

namespace diefill::process {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

results::CellField empty_field(const std::array<std::vector<double>, 3>& edges) {
  for (const auto& axis : edges)
    if (axis.size() < 2 || std::adjacent_find(axis.begin(), axis.end(), std::greater_equal<>()) != axis.end())
      throw std::invalid_argument("cells need at least two edges along each coordinate, in rising order");
  results::CellField field{"solid volume", "m^3", false, edges, {}};
  field.value.assign(field.size(), 0.0);
  return field;
}

/// What each sphere counts for its own volume: 1, or less where the spheres of its grain overlap.
std::vector<double> sphere_weights(const results::PowderState& powder, const std::vector<double>& radii) {
  const auto grains = powder.grains_of_spheres();
  std::vector<double> volumes(powder.position.size(), 0.0);
  for (std::size_t n = 0; n < radii.size(); ++n)
    volumes[grains[n]] += 4 * std::numbers::pi / 3 * std::pow(radii[n], 3);
  std::vector<double> weights;
  for (const std::uint32_t grain : grains) {
    const double solid = powder.solid_volume_of(grain);
    weights.push_back(solid > 0 ? solid / volumes[grain] : 1);
  }
  return weights;
}

double cell_volume(const results::CellField& field, std::size_t i, std::size_t j, std::size_t k) {
  const auto length = [&](std::size_t axis, std::size_t n) {
    return field.edges[axis][n + 1] - field.edges[axis][n];
  };
  if (!field.cylindrical) return length(0, i) * length(1, j) * length(2, k);
  const double middle = 0.5 * (field.edges[0][i] + field.edges[0][i + 1]);
  return middle * length(0, i) * kRadians * length(1, j) * length(2, k);
}

}  // namespace

std::vector<double> even_edges(double lower, double upper, int cells) {
  std::vector<double> edges;
  for (int n = 0; n <= cells; ++n) edges.push_back(n == cells ? upper : lower + (upper - lower) * n / cells);
  return edges;
}

results::CellField cartesian_volumes(const results::PowderState& powder,
                                     const std::array<std::vector<double>, 3>& edges) {
  results::CellField field = empty_field(edges);
  const auto radii = powder.radii_of_spheres();
  const auto weights = sphere_weights(powder, radii);
  const auto centres = powder.sphere_centres();
  for (std::size_t n = 0; n < centres.size(); ++n)
    share_sphere(field, {centres[n].x(), centres[n].y(), centres[n].z()}, radii[n], weights[n]);
  return field;
}

results::CellField cylindrical_volumes(const results::PowderState& powder, const results::CavityState& cavity,
                                       const std::array<std::vector<double>, 3>& edges) {
  results::CellField field = empty_field(edges);
  if (edges[0].front() < 0 || edges[1].back() - edges[1].front() > 360 + 1e-9)
    throw std::invalid_argument("cylindrical cells need radii from 0 and at most 360 degrees of azimuth");
  field.cylindrical = true;
  for (double& angle : field.edges[1]) angle *= kRadians;
  const auto radii = powder.radii_of_spheres();
  const auto weights = sphere_weights(powder, radii);
  const auto centres = powder.sphere_centres();
  for (std::size_t n = 0; n < centres.size(); ++n) {
    const RingPosition place = ring_position(cavity, centres[n]);
    share_sphere_round(field, place.radius, place.azimuth * kRadians, place.height, radii[n], weights[n]);
  }
  field.edges = edges;
  return field;
}

results::CellField solid_fraction_of(const results::CellField& volumes) {
  results::CellField fraction = volumes;
  fraction.quantity = std::string("solid fraction");
  fraction.unit = std::string("1");
  for (std::size_t k = 0; k < fraction.cells(2); ++k)
    for (std::size_t j = 0; j < fraction.cells(1); ++j)
      for (std::size_t i = 0; i < fraction.cells(0); ++i)
        fraction.value[fraction.cell(i, j, k)] /= cell_volume(fraction, i, j, k);
  return fraction;
}

results::Field2D partial_volume_map(const results::PowderState& powder, const results::CavityState& cavity,
                                    int azimuth_cells, int height_cells) {
  const double depth = cavity.upper_corner.z() - cavity.lower_corner.z();
  if (!cavity.is_ring || !(depth > 0) || !(cavity.outer_radius > cavity.inner_radius))
    throw std::invalid_argument("a cylindrical map needs a ring with a depth and two radii");
  if (azimuth_cells < 2 || height_cells < 2)
    throw std::invalid_argument("a cylindrical map needs at least two cells along either coordinate");
  const auto fraction = solid_fraction_of(
      cylindrical_volumes(powder, cavity,
                          {std::vector<double>{cavity.inner_radius, cavity.outer_radius},
                           even_edges(0, 360, azimuth_cells), even_edges(0, depth, height_cells)}));
  results::Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", {}, {}, fraction.value, 0};
  for (int i = 0; i < azimuth_cells; ++i) map.first.push_back((i + 0.5) * 360 / azimuth_cells);
  for (int j = 0; j < height_cells; ++j) map.second.push_back((j + 0.5) * depth / height_cells * 1e3);
  for (double& value : map.value)
    if (!(value > 0)) value = std::numeric_limits<double>::quiet_NaN();
  return map;
}

}  // namespace diefill::process
