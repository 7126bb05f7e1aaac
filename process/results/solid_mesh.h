// A finite-element mesh of solids, as a press simulation has it: nodes and elements with their numbers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace diefill::results {

/// Nodes in the order of VTK, in which Abaqus and CalculiX have them too: corners, then middles of edges.
enum class ElementShape { tetra4, tetra10, hexa8, hexa20, wedge6, wedge15, pyramid5 };

/// Facts about one shape.
struct ElementKind {
  ElementShape shape;
  int nodes;         ///< of one element
  int vtk;           ///< number of the cell type in VTK
  const char* name;  ///< such as "tetrahedron of 10 nodes"
  /// Nodes round each face, with middles of edges between corners.
  std::vector<std::vector<int>> faces;
};

const ElementKind& kind_of(ElementShape shape);
/// All shapes, to look one up by its number in VTK or its nodes.
const std::vector<ElementKind>& element_kinds();

/// Places in SolidMesh::nodes; those beyond the shape's number are not used.
struct SolidElement {
  ElementShape shape = ElementShape::tetra4;
  std::uint64_t number = 0;  ///< in the user's mesh
  std::array<std::uint32_t, 20> nodes{};
};

/// The elements with volume of a mesh, and the nodes that they use.
struct SolidMesh {
  std::vector<Eigen::Vector3d> nodes;       ///< m
  std::vector<std::uint64_t> node_numbers;  ///< in the user's mesh
  std::vector<SolidElement> elements;
  std::size_t left_out = 0;  ///< elements without volume (points, edges, surfaces) in the file
};

/// Corners of a tetrahedron, m.
using Tetrahedron = std::array<Eigen::Vector3d, 4>;

/// The element as tetrahedra between its middle and triangles of its faces: exact for straight elements; a
/// curved face is replaced by triangles over its nodes and its middle.
std::vector<Tetrahedron> tetrahedra_of(const SolidMesh& mesh, const SolidElement& element);

/// m^3, with the sign of the order of its corners.
double signed_volume(const Tetrahedron& tetrahedron);

/// m^3 of an element, whichever way round its nodes are given.
double volume_of(const SolidMesh& mesh, const SolidElement& element);

/// Removes nodes that no element uses; elements keep theirs.
void drop_unused_nodes(SolidMesh& mesh);

/// Throws std::invalid_argument for a mesh without elements, an element without volume or with nodes in
/// another order than theirs, and two nodes or two
/// elements of one number; the message names it.
void check_solid_mesh(const SolidMesh& mesh);

}  // namespace diefill::results
