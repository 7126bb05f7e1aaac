// Whether the nodes of an element stand in their order: the sign of the Jacobian at its corners.
#pragma once

#include <string>

#include "process/results/solid_mesh.h"

namespace diefill::results {

/// What is wrong with the order of the element's nodes, such as "is twisted: ..."; empty where nothing is.
/// The Jacobian must not be negative at any corner; wedges may be the other way round as a whole, because VTK
/// and Abaqus differ. Corners that are drawn together into an edge, as in collapsed hexahedra, count as none.
std::string fault_of_corners(const SolidMesh& mesh, const SolidElement& element);

}  // namespace diefill::results
