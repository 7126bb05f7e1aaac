// The sample tools as the tests of geometry need them.
#pragma once

#include <string>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry::sample {

/// Mesh (m) of a file in sample_tools, such as "narrow_ring/core_rod.stl".
Mesh tool(const std::string& file);

/// A block without a floor round a round bore open at top and bottom: x and y from -half to half, z from
/// -height to 0. Lengths in m.
Mesh bored_block(double half, double height, double radius, int facets);

}  // namespace diefill::geometry::sample
