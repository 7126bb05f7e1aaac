// Solid volume in the cells of a grid, every sphere divided exactly among the cells it overlaps. Counting
// whole grains by their centres instead jumps by a grain's volume whenever a centre crosses a face.
#pragma once

#include "process/results/cell_field.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Boundaries of `cells` equal cells from `lower` to `upper`.
std::vector<double> even_edges(double lower, double upper, int cells);

/// Solid volume (m^3) in Cartesian cells; edges in m, laboratory frame. Exact for spheres: what lies outside
/// the grid is not counted, everything else sums to the total up to rounding. Grains of overlapping spheres:
/// each sphere counts with its share of the grain's solid volume. Throws std::invalid_argument where edges do
/// not rise or are fewer than two.
results::CellField cartesian_volumes(const results::PowderState& powder,
                                     const std::array<std::vector<double>, 3>& edges);

/// Solid volume (m^3) in cylindrical cells around the cavity's axis: edges of radius (m, from 0 at least),
/// azimuth (deg, spanning at most 360) and height (m above the cavity floor). Exact where a sphere crosses no
/// cylinder, else integrated over height between the heights at which the cut changes its shape, to better
/// than 1e-9 of the sphere; sums as above. Throws std::invalid_argument as above.
results::CellField cylindrical_volumes(const results::PowderState& powder, const results::CavityState& cavity,
                                       const std::array<std::vector<double>, 3>& edges);

/// Solid volume over cell volume.
results::CellField solid_fraction_of(const results::CellField& volumes);

/// Solid fraction by partial volumes over azimuth and height of a ring, mean over its width: the map that
/// needs no averaging width. Nodes are cell middles. Throws std::invalid_argument for other cavities or no
/// cells.
results::Field2D partial_volume_map(const results::PowderState& powder, const results::CavityState& cavity,
                                    int azimuth_cells, int height_cells);

}  // namespace diefill::process
