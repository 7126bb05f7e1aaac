// The findings of a mesh check as text.
#include <iomanip>
#include <sstream>

#include "geometry/mesh/mesh_check.h"

namespace diefill::geometry {

namespace {

std::string in_millimetres(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "(" << 1e3 * place.x() << ", " << 1e3 * place.y() << ", "
       << 1e3 * place.z() << ") mm";
  return text.str();
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Writes one line per finding; takes the places in order.
class Writer {
 public:
  explicit Writer(const std::vector<Eigen::Vector3d>& places) : places_(places) {}
  void write(std::size_t count, const std::string& one, const std::string& many,
             const std::string& consequence, const std::string& advice) {
    if (count == 0) return;
    lines.push_back(counted(count, one, many) + ": " + consequence + " near " +
                    in_millimetres(places_[lines.size()]) + "; " + advice);
  }
  std::vector<std::string> lines;

 private:
  const std::vector<Eigen::Vector3d>& places_;
};

}  // namespace

bool MeshFindings::usable() const {
  return shells > 0 && not_finite == 0 && open_edges == 0 && non_manifold_edges == 0 &&
         self_intersections == 0 && consistently_oriented && outward;
}

std::vector<std::string> MeshFindings::description() const {
  if (triangles == 0) return {"no triangles: there is no surface; export the solid as a surface mesh"};
  Writer writer(places);
  writer.write(not_finite, "triangle with an invalid corner", "triangles with an invalid corner",
               "a coordinate is not a finite number or a corner does not exist, location unknown, shown",
               "export it again");
  writer.write(open_edges, "open edge", "open edges", "the surface has a hole", "close the solid in CAD");
  writer.write(non_manifold_edges, "edge shared by more than two triangles",
               "edges shared by more than two triangles", "sheets or solids touch along an edge",
               "separate or unite the solids in CAD");
  writer.write(self_intersections, "pair of triangles that cross", "pairs of triangles that cross",
               "the surface passes through itself", "unite overlapping solids in CAD");
  writer.write(badly_oriented_edges, "edge with neighbours facing opposite ways",
               "edges with neighbours facing opposite ways", "triangles are flipped",
               "recalculate the normals in CAD");
  const std::string consequence = inward_shells == shells && volume < 0
                                      ? "the whole surface is inside out, normals point into the solid,"
                                      : "it is inside out or lies inside another solid,";
  writer.write(inward_shells, "shell faces the wrong way", "shells face the wrong way", consequence,
               "reverse the normals in CAD or remove the inner solid");
  writer.write(degenerate_triangles, "triangle without area", "triangles without area",
               "slivers from the export", "harmless by themselves");
  writer.write(duplicate_triangles, "duplicate triangle", "duplicate triangles",
               "same corners as another triangle", "harmless by themselves, the copies are ignored");
  return writer.lines;
}

}  // namespace diefill::geometry
