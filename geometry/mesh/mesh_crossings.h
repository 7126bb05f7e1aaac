// Pairs of triangles of a mesh that cross each other.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Pairs of triangles (indices, lower first, sorted) that pass through or lie on each other. Both triangles
/// are first shrunk by 1e-5 about their middle, so that sharing an edge or corner, or touching within the
/// rounding of a CAD file, is no crossing. `left_out` holds 1 for triangles to ignore; degenerate triangles
/// have to be among them. Ends after 100,000 pairs.
std::vector<std::pair<std::size_t, std::size_t>> find_crossings(const Mesh& mesh,
                                                                const std::vector<std::uint8_t>& left_out);

}  // namespace diefill::geometry
