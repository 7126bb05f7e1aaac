// Where powder is: the same outline for all fields of one instant, with or without values.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/voronoi/neighbour_grid.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Tells which places are within reach of a grain centre. Grains with open cells count like all others:
/// powder is there although its solid fraction is not known.
class PowderPlaces {
 public:
  explicit PowderPlaces(const results::PowderState& powder);

  /// True where a grain centre is within kReachOverDiameter d of `point` (m): everywhere in a random packing,
  /// and that far beyond its surface.
  bool near(const Eigen::Vector3d& point) const;

  double grain_diameter() const { return diameter_; }

  static constexpr double kReachOverDiameter = 1.2;
  /// The powder ends half a grain beyond the outermost centres, as its spheres do.
  static constexpr double kSurfaceOverDiameter = 0.5;

 private:
  double diameter_, reach_;
  geometry::NeighbourGrid grid_;
};

/// Nodes of a plane grid, columns running fastest, `step` (m) apart along both of its axes.
struct NodeGrid {
  std::size_t columns = 0, rows = 0;
  double first_step = 0, second_step = 0;
  bool closed = false;  ///< the first axis runs round: its last node is its first
};

/// Erodes `near` (one a node): removes what lies within `depth` (m) of a node that is not near and has no
/// tool there (`is_tool` by column and row, called only at the edge of what is near): what is left ends at
/// the powder's surface and at tools, and holes wider than the reach stay holes. Beyond the grid counts as
/// near.
void erode_edges(std::vector<std::uint8_t>& near, const NodeGrid& grid, double depth,
                 const std::function<bool(std::size_t, std::size_t)>& is_tool);

/// Depth for erode_edges() that leaves the powder's own outline of what PowderPlaces calls near.
inline double outline_depth(const PowderPlaces& places) {
  return (PowderPlaces::kReachOverDiameter - PowderPlaces::kSurfaceOverDiameter) * places.grain_diameter();
}

}  // namespace diefill::process
