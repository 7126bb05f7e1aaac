#include "process/results/solid_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/results/element_corners.h"

namespace diefill::results {
namespace {

Eigen::Vector3d mean(const SolidMesh& mesh, const SolidElement& element, const std::vector<int>& nodes,
                     std::size_t first, std::size_t step) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (std::size_t n = first; n < nodes.size(); n += step, ++count)
    sum += mesh.nodes[element.nodes[static_cast<std::size_t>(nodes[n])]];
  return sum / static_cast<double>(count);
}

/// The middle of a face from its corners, and from the middles of its edges where it has those: a face of
/// second order bulges (shape functions of 6 and 8 nodes at the middle).
Eigen::Vector3d middle_of_face(const SolidMesh& mesh, const SolidElement& element,
                               const std::vector<int>& face, bool second_order) {
  if (!second_order) return mean(mesh, element, face, 0, 1);
  const Eigen::Vector3d corners = mean(mesh, element, face, 0, 2), edges = mean(mesh, element, face, 1, 2);
  const bool triangle = face.size() == 6;
  return triangle ? Eigen::Vector3d(-corners / 3 + 4 * edges / 3) : Eigen::Vector3d(2 * edges - corners);
}

void refuse_twins(std::vector<std::uint64_t> numbers, const std::string& what) {
  std::sort(numbers.begin(), numbers.end());
  const auto twin = std::adjacent_find(numbers.begin(), numbers.end());
  if (twin != numbers.end())
    throw std::invalid_argument(what + " " + std::to_string(*twin) +
                                " is defined twice, allowed: each number once");
}

std::vector<ElementKind> tetrahedra() {
  return {
      {ElementShape::tetra4, 4, 10, "tetrahedron of 4 nodes", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
      {ElementShape::tetra10,
       10,
       24,
       "tetrahedron of 10 nodes",
       {{0, 6, 2, 5, 1, 4}, {0, 4, 1, 8, 3, 7}, {1, 5, 2, 9, 3, 8}, {2, 6, 0, 7, 3, 9}}},
  };
}

std::vector<ElementKind> hexahedra() {
  return {
      {ElementShape::hexa8,
       8,
       12,
       "hexahedron of 8 nodes",
       {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
      {ElementShape::hexa20,
       20,
       25,
       "hexahedron of 20 nodes",
       {{0, 11, 3, 10, 2, 9, 1, 8},
        {4, 12, 5, 13, 6, 14, 7, 15},
        {0, 8, 1, 17, 5, 12, 4, 16},
        {1, 9, 2, 18, 6, 13, 5, 17},
        {2, 10, 3, 19, 7, 14, 6, 18},
        {3, 11, 0, 16, 4, 15, 7, 19}}},
  };
}

std::vector<ElementKind> wedges() {
  return {
      {ElementShape::wedge6,
       6,
       13,
       "wedge of 6 nodes",
       {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {ElementShape::wedge15,
       15,
       26,
       "wedge of 15 nodes",
       {{0, 8, 2, 7, 1, 6},
        {3, 9, 4, 10, 5, 11},
        {0, 6, 1, 13, 4, 9, 3, 12},
        {1, 7, 2, 14, 5, 10, 4, 13},
        {2, 8, 0, 12, 3, 11, 5, 14}}},
  };
}

std::vector<ElementKind> pyramids() {
  return {
      {ElementShape::pyramid5,
       5,
       14,
       "pyramid of 5 nodes",
       {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
  };
}

}  // namespace

const std::vector<ElementKind>& element_kinds() {
  static const std::vector<ElementKind> all = [] {
    std::vector<ElementKind> kinds;  // in the order of ElementShape, for kind_of
    for (const auto& some : {tetrahedra(), hexahedra(), wedges(), pyramids()})
      kinds.insert(kinds.end(), some.begin(), some.end());
    return kinds;
  }();
  return all;
}

const ElementKind& kind_of(ElementShape shape) {
  return element_kinds()[static_cast<std::size_t>(shape)];
}

double signed_volume(const Tetrahedron& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]) / 6;
}

std::vector<Tetrahedron> tetrahedra_of(const SolidMesh& mesh, const SolidElement& element) {
  const ElementKind& kind = kind_of(element.shape);
  const bool second_order = kind.nodes > 8;
  std::vector<Eigen::Vector3d> middles;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& face : kind.faces) {
    middles.push_back(middle_of_face(mesh, element, face, second_order));
    middle += middles.back() / static_cast<double>(kind.faces.size());
  }
  std::vector<Tetrahedron> parts;
  for (std::size_t f = 0; f < kind.faces.size(); ++f) {
    const auto& face = kind.faces[f];
    const auto place = [&](std::size_t n) {
      return mesh.nodes[element.nodes[static_cast<std::size_t>(face[n % face.size()])]];
    };
    if (face.size() == 3)
      parts.push_back({place(0), place(1), place(2), middle});
    else
      for (std::size_t n = 0; n < face.size(); ++n)
        parts.push_back({place(n), place(n + 1), middles[f], middle});
  }
  return parts;
}

double volume_of(const SolidMesh& mesh, const SolidElement& element) {
  double volume = 0;
  for (const auto& part : tetrahedra_of(mesh, element)) volume += signed_volume(part);
  return std::abs(volume);
}

void drop_unused_nodes(SolidMesh& mesh) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.nodes.size(), kUnused);
  const auto used_by = [](SolidElement& element) {
    return std::pair(element.nodes.begin(), element.nodes.begin() + kind_of(element.shape).nodes);
  };
  for (auto& element : mesh.elements) {
    const auto [begin, end] = used_by(element);
    for (auto node = begin; node != end; ++node) place[*node] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (place[n] == kUnused) continue;
    mesh.nodes[kept] = mesh.nodes[n];
    mesh.node_numbers[kept] = mesh.node_numbers[n];
    place[n] = kept++;
  }
  mesh.nodes.resize(kept);
  mesh.node_numbers.resize(kept);
  for (auto& element : mesh.elements) {
    const auto [begin, end] = used_by(element);
    for (auto node = begin; node != end; ++node) *node = place[*node];
  }
}

void check_solid_mesh(const SolidMesh& mesh) {
  if (mesh.elements.empty())
    throw std::invalid_argument(
        "found no element with volume, allowed: tetrahedra, hexahedra, wedges and pyramids");
  std::vector<std::uint64_t> numbers;
  for (const auto& element : mesh.elements) {
    const Eigen::Vector3d first = mesh.nodes[element.nodes[0]];
    double size = 0;
    for (int n = 1; n < kind_of(element.shape).nodes; ++n)
      size = std::max(size, (mesh.nodes[element.nodes[static_cast<std::size_t>(n)]] - first).norm());
    if (!(volume_of(mesh, element) > 1e-9 * size * size * size))
      throw std::invalid_argument("element " + std::to_string(element.number) +
                                  " has no volume; repair the mesh");
    if (const std::string fault = fault_of_corners(mesh, element); !fault.empty())
      throw std::invalid_argument("element " + std::to_string(element.number) + ' ' + fault);
    numbers.push_back(element.number);
  }
  refuse_twins(std::move(numbers), "element");
  refuse_twins(mesh.node_numbers, "node");
}

}  // namespace diefill::results
