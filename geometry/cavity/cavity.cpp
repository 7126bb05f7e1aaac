#include "geometry/cavity/cavity.h"

#include <algorithm>
#include <cmath>

#include "geometry/cavity/cavity_shape.h"

namespace diefill::geometry {
namespace {

constexpr double kVoxels = 4e6;
constexpr double kFinestVoxel = 5e-5;  // m
constexpr int kMargin = 4;             // voxels of the first search kept round what it found

// The part of space that the solids take up below the fill plane.
Box space_below(const std::vector<const Mesh*>& solids, double fill_plane) {
  Box box;
  for (const auto* solid : solids) box.include(solid->bounding_box());
  box.upper.z() = fill_plane;
  return box;
}

double voxel_edge(const Box& box) {
  return std::max(kFinestVoxel, std::cbrt(box.size().prod() / kVoxels));
}

// Over `box`, a voxel beyond it on all sides but the top, with voxel borders on the point `origin`.
VoxelGrid grid_from(const Eigen::Vector3d& origin, double edge, const Box& box) {
  const Eigen::Array3d before = ((origin - box.lower) / edge).array().ceil() + 1;
  VoxelGrid grid{origin - before.matrix() * edge, edge, {}};
  grid.counts = (((box.upper - grid.origin) / edge).array().ceil() + 1).cast<int>().matrix();
  grid.counts.z() = static_cast<int>(std::lround((origin.z() - grid.origin.z()) / edge));
  return grid;
}

// The lines of centres are shifted by an uneven part of a voxel: they would otherwise run along faces of
// symmetric tools.
VoxelGrid coarse_grid(const Box& space) {
  const double edge = voxel_edge(space);
  return grid_from({space.lower.x() - 0.37 * edge, space.lower.y() - 0.29 * edge, space.upper.z()}, edge,
                   space);
}

// Finer, round what the first search found. A whole number of voxels fits into the shorter of its sides, so
// that the voxels' edges lie on straight walls and the volume of box-like cavities comes out right.
VoxelGrid fine_grid(const CavityRegion& found, const Box& space) {
  const double margin = kMargin * found.grid.edge;
  Box box;
  box.lower = (found.box.lower.array() - margin).max(space.lower.array()).matrix();
  box.upper = (found.box.upper.array() + margin).min(space.upper.array()).matrix();
  const double side = found.box.size().head<2>().minCoeff();
  const double edge = side / std::ceil(side / voxel_edge(box));
  return grid_from({found.box.lower.x(), found.box.lower.y(), space.upper.z()}, edge, box);
}

Footprint footprint_of(const CavityRegion& region) {
  const VoxelGrid& grid = region.grid;
  Footprint footprint{grid.origin.head<2>(), grid.edge, grid.counts.head<2>(), {}};
  const std::size_t layer = grid.index(0, 0, 1);
  footprint.covered.assign(layer, 0);
  for (std::size_t n = 0; n < region.inside.size(); ++n)
    if (region.inside[n] != 0) footprint.covered[n % layer] = 1;
  return footprint;
}

// The shape of a region from the tools' outlines; not found where there are none.
Cavity read_off(const CavityRegion& region, const std::vector<const Mesh*>& solids, double fill_plane) {
  Cavity cavity;
  const auto layers = layer_parts(region);
  const auto slices = without_tapering_ends(region, layers, cavity_slices(region, layers, solids));
  if (slices.empty()) return cavity;
  cavity.found = true;
  cavity.box = region.box;
  cavity.volume = region.volume;
  cavity.footprint = footprint_of(region);
  const auto ring = fit_ring(slices, region.grid.edge);
  const auto narrowest = ring ? ring->narrowest : narrowest_width(region, layers, slices);
  cavity.narrowest_width = narrowest.width;
  cavity.narrowest_place = narrowest.place;
  const Eigen::Vector2d axis =
      ring ? ring->axis : Eigen::Vector2d((cavity.box.lower + cavity.box.upper).head<2>() / 2);
  cavity.axis_origin = {axis.x(), axis.y(), fill_plane};
  if (ring) {
    cavity.is_ring = true;
    cavity.inner_radius = ring->inner_radius;
    cavity.outer_radius = ring->outer_radius;
  }
  return cavity;
}

}  // namespace

bool Footprint::covers(const Eigen::Vector2d& place) const {
  const Eigen::Array2d at = ((place - origin) / edge).array().floor();
  if (edge <= 0 || (at < 0).any() || (at >= counts.array().cast<double>()).any()) return false;
  const auto x = static_cast<std::size_t>(at.x()), y = static_cast<std::size_t>(at.y());
  return covered[y * static_cast<std::size_t>(counts.x()) + x] != 0;
}

std::vector<Cavity> find_cavities(const std::vector<const Mesh*>& solids, double fill_plane) {
  std::vector<Cavity> cavities;
  const Box space = space_below(solids, fill_plane);
  if (solids.empty() || space.size().minCoeff() <= 0) return cavities;
  for (const auto& coarse : find_cavity_regions(solids, coarse_grid(space))) {
    // Others that the finer grid meets have a way out through its sides.
    const auto finer = find_cavity_regions(solids, fine_grid(coarse, space));
    const Cavity cavity = read_off(finer.empty() ? coarse : finer.front(), solids, fill_plane);
    if (cavity.found) cavities.push_back(cavity);
  }
  std::stable_sort(cavities.begin(), cavities.end(),
                   [](const Cavity& a, const Cavity& b) { return a.volume > b.volume; });
  return cavities;
}

Cavity find_cavity(const std::vector<const Mesh*>& solids, double fill_plane) {
  const auto cavities = find_cavities(solids, fill_plane);
  return cavities.empty() ? Cavity{} : cavities.front();
}

}  // namespace diefill::geometry
