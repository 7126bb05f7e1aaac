#include "process/run/tooling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <stdexcept>

#include "geometry/solid_query.h"
#include "process/run/periodic_tool.h"
#include "process/run/reachable_surface.h"
#include "process/run/tool_fit.h"

namespace diefill::process {

namespace {

bool moves(const Scene& scene, const std::string& tool) {
  return std::any_of(scene.steps.begin(), scene.steps.end(),
                     [&](const auto& step) { return step->tool() == tool; });
}

geometry::Box moved_box(const geometry::Mesh& mesh, const ToolPose& pose) {
  return geometry::transformed(mesh, pose.rotation, pose.translation).bounding_box();
}

/// Tells every step what it may ask, in order: a step starts where the ones before left its tool.
void prepare_steps(const Scene& scene, const Tooling& tooling) {
  std::vector<ToolPose> pose(tooling.tools.size());
  for (const auto& step : scene.steps) {
    MachineContext context;
    context.gravity = scene.gravity;
    if (tooling.cavity.found) {
      context.cavity_lower = tooling.cavity.box.lower;
      context.cavity_upper = tooling.cavity.box.upper;
    }
    if (step->tool().empty()) {
      step->prepare(context);
      continue;
    }
    const std::size_t k = tooling.index_of(step->tool());
    const geometry::Box box = moved_box(tooling.tools[k].mesh, pose[k]);
    context.tool_lower = box.lower;
    context.tool_upper = box.upper;
    step->prepare(context);
    if (step->duration()) pose[k] = compose(step->motion(*step->duration()), pose[k]);
  }
}

double sphere_radius(const Scene& scene, const ToolSpec& spec) {
  return spec.sphere_radius.value_or(scene.walls.sphere_radius);
}

void refuse_misplaced(const Scene& scene, const Tooling& tooling) {
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      check_fit(tooling.tools[k], tooling.tools[other], sphere_radius(scene, tooling.tools[k].spec),
                tool_in_words(scene, tooling.tools[k].spec));
}

/// Openings measured between centres (OP-12): the spheres' centres, not their surfaces, lie on the CAD
/// surface.
void move_to_surface(geometry::WallSpheres& spheres, const geometry::Mesh& mesh) {
  const geometry::SolidQuery solid(mesh);
  for (auto& centre : spheres.centres) centre = solid.nearest(centre).point;
  spheres.mean_deviation += spheres.radius;
  spheres.largest_deviation += spheres.radius;
}

/// The tool's wall spheres; complaints about its geometry name the tool.
geometry::WallSpheres cover(const Scene& scene, const Tool& tool, double grain_diameter,
                            decltype(geometry::WallSphereOptions::reachable) reachable) {
  const std::string where = tool_in_words(scene, tool.spec);
  geometry::WallSphereOptions options;
  options.radius = sphere_radius(scene, tool.spec);
  options.spacing = tool.spec.spacing.value_or(scene.walls.spacing);
  options.reachable = std::move(reachable);
  try {
    auto spheres =
        make_periodic_wall_spheres(tool.mesh, options, scene.numerics.period, 2 * grain_diameter, where);
    if (scene.numerics.opening == OpeningMeasure::centres) move_to_surface(spheres, tool.mesh);
    return spheres;
  } catch (const geometry::MeshError& error) {
    throw SceneError(where + ": " + error.what());
  }
}

void refuse_leaks(const Scene& scene, const Tool& tool, double smallest_radius) {
  if (tool.spheres.largest_gap < 2 * smallest_radius) return;
  char text[300];
  const Eigen::Vector3d place = tool.spheres.largest_gap_place * 1e3;
  std::snprintf(
      text, sizeof text,
      ": a grain's sphere of %.4g mm diameter could pass the wall through a gap of %.4g mm near (%.2f, %.2f, "
      "%.2f) mm; lower the spacing of the wall spheres or their radius",
      2e3 * smallest_radius, 1e3 * tool.spheres.largest_gap, place[0], place[1], place[2]);
  throw SceneError(tool_in_words(scene, tool.spec) + text);
}

}  // namespace

std::size_t Tooling::wall_spheres() const {
  std::size_t count = 0;
  for (const auto& tool : tools) count += tool.spheres.centres.size();
  return count;
}

std::vector<std::string> Tooling::remarks() const {
  std::vector<std::string> lines;
  for (const Tool& tool : tools) {
    const std::string name = "tool \"" + tool.spec.name + "\"";
    for (const auto& repair : tool.repairs) lines.push_back(name + " repaired: " + repair);
    if (tool.spec.part.empty() && tool.file_parts.size() > 1)
      lines.push_back(name + ": all " + std::to_string(tool.file_parts.size()) + " parts of " +
                      tool.spec.file.filename().string() + " taken together; `part` picks one");
  }
  return lines;
}

std::size_t Tooling::index_of(const std::string& name) const {
  for (std::size_t k = 0; k < tools.size(); ++k)
    if (tools[k].spec.name == name) return k;
  throw std::out_of_range("no tool named " + name);
}

ToolPose compose(const ToolMotion& motion, const ToolPose& before) {
  ToolPose pose;
  pose.rotation = motion.rotation * before.rotation;
  const Eigen::Vector3d pivot = motion.pivot + motion.translation;
  pose.translation = motion.rotation * (before.translation - motion.pivot) + pivot;
  pose.angular_velocity = motion.angular_velocity;
  pose.velocity = motion.velocity + motion.angular_velocity.cross(pose.translation - pivot);
  return pose;
}

Tooling build_tooling(const Scene& scene, double smallest_radius, double grain_diameter) {
  Tooling tooling;
  std::vector<const geometry::Mesh*> standing;
  for (const auto& spec : scene.tools) tooling.tools.push_back(read_tool(scene, spec));
  for (const auto& tool : tooling.tools) refuse_unusable(scene, tool);
  refuse_misplaced(scene, tooling);
  for (const auto& tool : tooling.tools) {
    const geometry::Box box = tool.mesh.bounding_box();
    tooling.all.include(box);
    if (tool.spec.role == ToolRole::shoe) continue;
    standing.push_back(&tool.mesh);
    if (!moves(scene, tool.spec.name)) tooling.standing.include(box);
  }
  if (standing.empty())
    throw SceneError(scene.file.string() +
                     ": tool: no die or plate to pour powder on; add one [[tool]] whose role is not shoe");
  if (tooling.standing.size().minCoeff() < 0)
    throw SceneError(scene.file.string() +
                     ": tool: every one moves in some step; powder needs at least one that stands");
  tooling.cavity = geometry::find_cavity(standing, scene.measure.fill_plane);
  prepare_steps(scene, tooling);

  const ReachableSurface reachable(scene, tooling, grain_diameter);
  // Tools do not know of each other: they are covered side by side.
  std::vector<std::future<geometry::WallSpheres>> covered;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    covered.push_back(std::async(std::launch::async, [&, k] {
      return cover(scene, tooling.tools[k], grain_diameter,
                   [&, k](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
                     return reachable(k, point, normal);
                   });
    }));
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    tooling.tools[k].spheres = covered[k].get();
    refuse_leaks(scene, tooling.tools[k], smallest_radius);
  }
  return tooling;
}

}  // namespace diefill::process
