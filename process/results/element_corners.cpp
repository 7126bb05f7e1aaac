#include "process/results/element_corners.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace diefill::results {
namespace {

/// A neighbour along an edge, and the node at the middle of it; -1: elements of first order have none.
struct Neighbour {
  int corner = 0, middle = -1;

  bool operator==(const Neighbour&) const = default;
};

/// A corner with the ends of its three edges: outwards of a face lies the way from the first to the second.
struct Corner {
  int corner = 0;
  std::vector<Neighbour> ends;
};

/// The neighbours of a corner in a face that is listed counter-clockwise as seen from outside: the next and
/// the one before.
std::array<Neighbour, 2> neighbours_in(const std::vector<int>& face, std::size_t at, bool second_order) {
  const std::size_t step = second_order ? 2 : 1, count = face.size();
  const auto node = [&](std::size_t ahead) { return face[(at + ahead) % count]; };
  return {
      {{node(step), second_order ? node(1) : -1}, {node(count - step), second_order ? node(count - 1) : -1}}};
}

/// Corners with three edges: all but the top of a pyramid.
std::vector<Corner> corners_of(const ElementKind& kind) {
  const bool second_order = kind.nodes > 8;
  std::vector<Corner> corners;
  for (int node = 0; node < kind.nodes; ++node) {
    Corner corner{node, {}};
    for (const auto& face : kind.faces)
      for (std::size_t at = 0; at < face.size(); at += second_order ? 2 : 1) {
        if (face[at] != node) continue;
        for (const Neighbour& end : neighbours_in(face, at, second_order))
          if (std::find(corner.ends.begin(), corner.ends.end(), end) == corner.ends.end())
            corner.ends.push_back(end);
      }
    if (corner.ends.size() == 3) corners.push_back(corner);
  }
  return corners;
}

/// Of the Jacobian at a corner: the triple product of the directions of its edges; 0 where an edge has no
/// length.
double turn_at(const SolidMesh& mesh, const SolidElement& element, const Corner& corner) {
  const auto place = [&](int node) { return mesh.nodes[element.nodes[static_cast<std::size_t>(node)]]; };
  const Eigen::Vector3d origin = place(corner.corner);
  // Tangents at the corner: of a parabola through three nodes where the edge has a middle.
  const auto tangent = [&](const Neighbour& end) -> Eigen::Vector3d {
    if (end.middle < 0) return place(end.corner) - origin;
    return 4 * place(end.middle) - 3 * origin - place(end.corner);
  };
  const Eigen::Vector3d first = tangent(corner.ends[0]), second = tangent(corner.ends[1]),
                        third = tangent(corner.ends[2]);
  const double lengths = first.norm() * second.norm() * third.norm();
  return lengths > 0 ? -first.cross(second).dot(third) / lengths : 0;
}

}  // namespace

std::string fault_of_corners(const SolidMesh& mesh, const SolidElement& element) {
  constexpr double kFlat = 1e-6;
  static const std::vector<std::vector<Corner>> all = [] {
    std::vector<std::vector<Corner>> of_kinds;
    for (const ElementKind& kind : element_kinds()) of_kinds.push_back(corners_of(kind));
    return of_kinds;
  }();
  std::size_t forwards = 0, backwards = 0;
  for (const Corner& corner : all[static_cast<std::size_t>(element.shape)]) {
    const double turn = turn_at(mesh, element, corner);
    forwards += turn > kFlat ? 1 : 0;
    backwards += turn < -kFlat ? 1 : 0;
  }
  const bool wedge = element.shape == ElementShape::wedge6 || element.shape == ElementShape::wedge15;
  if (backwards == 0 || (wedge && forwards == 0)) return {};
  if (forwards == 0)
    return "is inside out: the Jacobian is negative at all its corners; number its nodes the other way "
           "round, "
           "or export the mesh without a mirrored axis";
  return "is twisted: the Jacobian is negative at " + std::to_string(backwards) + " of its " +
         std::to_string(forwards + backwards) +
         " corners; check the order of its nodes, or mesh the part again";
}

}  // namespace diefill::results
