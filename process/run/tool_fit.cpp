#include "process/run/tool_fit.h"

#include <cstdio>

#include "geometry/solid_query.h"

namespace diefill::process {

namespace {

constexpr double kLargestTool = 2;  // m

/// Deepest corner of a part inside another.
struct Depth {
  double depth = 0;  ///< m
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

void deepen(Depth& deepest, const geometry::Mesh& part, const geometry::Mesh& solid) {
  const geometry::Box box = solid.bounding_box();
  const geometry::SolidQuery query(solid);
  for (const auto& corner : part.vertices) {
    if (!box.contains(corner)) continue;
    const double depth = -query.signed_distance(corner);
    if (depth > deepest.depth) deepest = {depth, corner};
  }
}

}  // namespace

void check_size(const geometry::Mesh& mesh, double sphere_radius, const std::string& where) {
  const Eigen::Vector3d size = mesh.bounding_box().size();
  const bool too_large = size.maxCoeff() > kLargestTool, too_small = size.maxCoeff() < 4 * sphere_radius;
  if (!too_large && !too_small) return;
  char text[240];
  std::snprintf(text, sizeof text,
                ": measures %.4g x %.4g x %.4g mm, %s; see whether length_unit is that of the CAD file",
                1e3 * size[0], 1e3 * size[1], 1e3 * size[2],
                too_large ? "and 2000 mm is the most" : "too small to be covered with wall spheres");
  throw SceneError(where + text);
}

void check_fit(const Tool& tool, const Tool& other, double sphere_radius, const std::string& where) {
  Depth deepest;
  deepen(deepest, tool.mesh, other.mesh);
  deepen(deepest, other.mesh, tool.mesh);
  if (deepest.depth <= sphere_radius) return;
  char text[120];
  std::snprintf(text, sizeof text,
                " overlap by %.3g mm near (%.2f, %.2f, %.2f) mm at the start; move one of them",
                1e3 * deepest.depth, 1e3 * deepest.place[0], 1e3 * deepest.place[1], 1e3 * deepest.place[2]);
  throw SceneError(where + " and tool \"" + other.spec.name + "\"" + text);
}

}  // namespace diefill::process
