// Meshes as CGAL types, for the code that repairs them.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry::cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

/// Triangles without connectivity.
struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

inline Soup soup_of(const Mesh& mesh) {
  Soup soup;
  for (const auto& v : mesh.vertices) soup.points.emplace_back(v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles)
    soup.triangles.push_back(
        {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
  return soup;
}

inline Mesh mesh_of(const Surface& surface) {
  Mesh mesh;
  std::vector<int> index(surface.number_of_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto vertex : surface.vertices()) {
    index[vertex.idx()] = static_cast<int>(mesh.vertices.size());
    const Point& p = surface.point(vertex);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    Eigen::Vector3i corners;
    int k = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face)))
      corners[k++] = index[vertex.idx()];
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace diefill::geometry::cgal
