#include "process/tooling/periodic_tool.h"

#include <cmath>

namespace diefill::process {

namespace {

/// Stretches the prism along `axis` to one period and `beyond` (m) at either end.
void fit_to_period(geometry::Mesh& mesh, Eigen::Index axis, double period, double beyond,
                   const std::string& where) {
  const geometry::Box box = mesh.bounding_box();
  const double lower = box.lower[axis], upper = box.upper[axis], tolerance = 1e-6 * (upper - lower);
  const std::string name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
  if (lower > -0.5 * period || upper < 0.5 * period)
    throw SceneError(where + ": shorter along " + name +
                     " than the period; extend the tool over the whole period");
  const double half = 0.5 * period + beyond;
  for (auto& vertex : mesh.vertices) {
    const bool at_lower = vertex[axis]<lower + tolerance, at_upper = vertex[axis]> upper - tolerance;
    if (!at_lower && !at_upper)
      throw SceneError(where + ": not uniform along " + name +
                       ", as a period in that direction requires; remove the period or use a prismatic tool");
    vertex[axis] = at_lower ? -half : half;
  }
}

/// One period of `centres` and its copies within `margin` of the box.
std::vector<Eigen::Vector3d> repeated(const std::vector<Eigen::Vector3d>& centres, Eigen::Index axis,
                                      double period, double margin) {
  const double half = 0.5 * period, tolerance = 1e-6 * period;
  std::vector<Eigen::Vector3d> all;
  for (const auto& centre : centres) {
    if (centre[axis] < -half - tolerance || centre[axis] > half - tolerance) continue;
    const int copies = static_cast<int>(std::ceil(margin / period));
    for (int n = -copies; n <= copies; ++n) {
      Eigen::Vector3d copy = centre;
      copy[axis] += n * period;
      if (std::abs(copy[axis]) <= half + margin) all.push_back(copy);
    }
  }
  return all;
}

}  // namespace

geometry::Mesh periodic_wall_mesh(const geometry::Mesh& mesh,
                                  const std::array<std::optional<double>, 3>& period, double margin,
                                  const std::string& where) {
  geometry::Mesh fitted = mesh;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (period[axis]) fit_to_period(fitted, static_cast<Eigen::Index>(axis), *period[axis], margin, where);
  return fitted;
}

geometry::WallSpheres make_periodic_wall_spheres(const geometry::Mesh& mesh,
                                                 const geometry::WallSphereOptions& options,
                                                 const std::array<std::optional<double>, 3>& period,
                                                 double margin, const std::string& where) {
  // Wall spheres lie R_w deep: the outermost rows come to stand exactly on the borders.
  const geometry::Mesh fitted = periodic_wall_mesh(mesh, period, options.radius, where);
  geometry::WallSpheres spheres = geometry::make_wall_spheres(fitted, options);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (period[axis])
      spheres.centres = repeated(spheres.centres, static_cast<Eigen::Index>(axis), *period[axis], margin);
  return spheres;
}

}  // namespace diefill::process
