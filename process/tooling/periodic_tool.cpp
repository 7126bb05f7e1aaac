#include "process/tooling/periodic_tool.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

namespace {

constexpr double kAlike = 1e-6;  // of the tool's length, that places may differ by

std::string name_of(Eigen::Index axis) {
  return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

/// Whether the tool stays within the period, by the clearance, wherever it moves.
bool stays_within(const geometry::Box& box, const PeriodicPath& path, Eigen::Index axis) {
  const double room = 0.5 * *path.period[static_cast<std::size_t>(axis)] - path.clearance;
  return path.may_stand_within && box.lower[axis] + path.lowest[axis] >= -room &&
         box.upper[axis] + path.highest[axis] <= room;
}

/// The cross-section at one end: the other two coordinates of its vertices, in order.
std::vector<std::pair<double, double>> section_at(const geometry::Mesh& mesh, Eigen::Index axis, double end,
                                                  double tolerance) {
  std::vector<std::pair<double, double>> section;
  for (const auto& vertex : mesh.vertices)
    if (std::abs(vertex[axis] - end) < tolerance)
      section.emplace_back(vertex[(axis + 1) % 3], vertex[(axis + 2) % 3]);
  std::sort(section.begin(), section.end());
  section.erase(std::unique(section.begin(), section.end()), section.end());
  return section;
}

/// Whether every place of one end's cross-section is one of the other's.
bool has_places_of(const std::vector<std::pair<double, double>>& section,
                   const std::vector<std::pair<double, double>>& other, double tolerance) {
  return std::all_of(other.begin(), other.end(), [&](const auto& place) {
    return std::any_of(section.begin(), section.end(), [&](const auto& one) {
      return std::abs(one.first - place.first) < tolerance && std::abs(one.second - place.second) < tolerance;
    });
  });
}

[[noreturn]] void refuse_uneven(const std::string& where, Eigen::Index axis, const std::string& because) {
  throw SceneError(where + ": not uniform along " + name_of(axis) + ", as " + because +
                   " requires; remove the period or use a prismatic tool");
}

/// Stretches a tool that reaches across the period along `axis` to `beyond` (m) past either border. What lies
/// between its ends must be within the period.
void fit_to_period(geometry::Mesh& mesh, Eigen::Index axis, const PeriodicPath& path, double beyond,
                   const std::string& where) {
  const geometry::Box box = mesh.bounding_box();
  const double period = *path.period[static_cast<std::size_t>(axis)];
  const double lower = box.lower[axis], upper = box.upper[axis], tolerance = kAlike * (upper - lower);
  if (lower > -0.5 * period || upper < 0.5 * period)
    throw SceneError(where + ": shorter along " + name_of(axis) +
                     " than the period; extend the tool over the whole period");
  const auto first = section_at(mesh, axis, lower, tolerance),
             last = section_at(mesh, axis, upper, tolerance);
  if (!has_places_of(first, last, tolerance) || !has_places_of(last, first, tolerance))
    refuse_uneven(where, axis, "a period in that direction");
  const double half = 0.5 * period + beyond, room = 0.5 * period - path.clearance;
  const bool moves = path.turns || path.lowest[axis] < 0 || path.highest[axis] > 0;
  for (auto& vertex : mesh.vertices) {
    const bool at_lower = vertex[axis]<lower + tolerance, at_upper = vertex[axis]> upper - tolerance;
    if (at_lower || at_upper) {
      vertex[axis] = at_lower ? -half : half;
      continue;
    }
    if (moves) refuse_uneven(where, axis, "its motion across the border of the period");
    if (std::abs(vertex[axis]) > room) refuse_uneven(where, axis, "a period in that direction");
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

/// m, the farthest that the tool moves along the axis, either way.
double way_along(const PeriodicPath& path, Eigen::Index axis) {
  return std::max(-path.lowest[axis], path.highest[axis]);
}

}  // namespace

PeriodicPath periodic_path(const Scene& scene, const ToolSpec& tool, double clearance) {
  constexpr int kInstants = 200;  // of every step that moves a tool
  PeriodicPath path{.period = scene.numerics.period,
                    .clearance = clearance,
                    .may_stand_within = tool.role == ToolRole::punch || tool.role == ToolRole::core};
  if (!path.period[0] && !path.period[1] && !path.period[2]) return path;
  const Stages stages(scene);
  if (!stages.moves(tool.name)) return path;
  const auto states = predicted(stages, kSettlingGuess);
  for (const double time : instants(stages, states, kInstants)) {
    const ToolPose pose = pose_of(stages, states, tool.name, time);
    path.lowest = path.lowest.cwiseMin(pose.translation);
    path.highest = path.highest.cwiseMax(pose.translation);
    path.turns = path.turns || !pose.rotation.isIdentity(1e-9);
  }
  return path;
}

geometry::Mesh periodic_wall_mesh(const geometry::Mesh& mesh, const PeriodicPath& path, double margin,
                                  const std::string& where) {
  geometry::Mesh fitted = mesh;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (path.period[static_cast<std::size_t>(axis)] && !stays_within(mesh.bounding_box(), path, axis))
      fit_to_period(fitted, axis, path, margin + way_along(path, axis), where);
  return fitted;
}

geometry::WallSpheres make_periodic_wall_spheres(const geometry::Mesh& mesh,
                                                 const geometry::WallSphereOptions& options,
                                                 const PeriodicPath& path, double margin,
                                                 const std::string& where) {
  geometry::Mesh fitted = mesh;
  // Wall spheres lie R_w deep: the outermost rows come to stand exactly on the borders.
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (path.period[static_cast<std::size_t>(axis)] && !stays_within(mesh.bounding_box(), path, axis))
      fit_to_period(fitted, axis, path, options.radius, where);
  geometry::WallSpheres spheres = geometry::make_wall_spheres(fitted, options);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (const auto& period = path.period[static_cast<std::size_t>(axis)])
      spheres.centres = repeated(spheres.centres, axis, *period, margin + way_along(path, axis));
  return spheres;
}

}  // namespace diefill::process
