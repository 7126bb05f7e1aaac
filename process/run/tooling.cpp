#include "process/run/tooling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <future>
#include <stdexcept>
#include <system_error>

#include "process/run/carried_powder.h"
#include "process/run/cover_progress.h"
#include "process/run/foreseen_work.h"
#include "process/run/half_model.h"
#include "process/run/no_cavity.h"
#include "process/run/periodic_tool.h"
#include "process/run/reachable_surface.h"
#include "process/run/read_tooling.h"
#include "process/run/stages.h"
#include "process/run/tool_fit.h"
#include "process/run/tool_paths.h"
#include "process/run/wall_sphere_limit.h"

namespace diefill::process {

namespace {

// Shares of the work, as a die of ten million triangles has them.
constexpr double kToolsRead = 0.24, kToolsFit = 0.3, kReachKnown = 0.33;

/// More than 0; what cannot be read is complained about when it is read.
double bytes_of(const ToolSpec& spec) {
  std::error_code failed;
  const auto size = std::filesystem::file_size(spec.file, failed);
  return failed ? 1 : 1 + static_cast<double>(size);
}

geometry::Box moved_box(const geometry::Mesh& mesh, const ToolPose& pose) {
  return geometry::transformed(mesh, pose.rotation, pose.translation).bounding_box();
}

/// Box of the step's tools where the steps before it in the scene leave them.
geometry::Box box_before(const Scene& scene, const Tooling& tooling, std::size_t step) {
  geometry::Box box;
  for (const auto& name : scene.steps[step]->tools()) {
    ToolPose pose;
    for (std::size_t k = 0; k < step; ++k) {
      const auto tools = scene.steps[k]->tools();
      if (std::find(tools.begin(), tools.end(), name) == tools.end() || scene.steps[k]->open_ended())
        continue;
      pose = compose(scene.steps[k]->motion(*scene.steps[k]->duration()), pose);
    }
    box.include(moved_box(tooling.tools[tooling.index_of(name)].mesh, pose));
  }
  return box;
}

/// The scene with some of its steps prepared, in order: those that need no cavity, which may make it, or the
/// others, once those are.
Scene prepare_steps(Scene scene, const Tooling& tooling, bool need_cavity) {
  for (std::size_t k = 0; k < scene.steps.size(); ++k) {
    if (scene.steps[k]->needs_cavity() != need_cavity) continue;
    MachineContext context;
    context.gravity = scene.gravity;
    if (tooling.cavity.found) {
      const geometry::Box all = tooling.all_cavities().box;
      context.cavity_lower = all.lower;
      context.cavity_upper = all.upper;
    }
    if (need_cavity) {
      const geometry::Box box = box_before(scene, tooling, k);
      context.tool_lower = box.lower;
      context.tool_upper = box.upper;
    }
    if (auto prepared = scene.steps[k]->prepared(context)) scene.steps[k] = std::move(prepared);
  }
  return scene;
}

/// Steps that can be followed before the cavity is known.
Scene without_passages(const Scene& scene) {
  Scene rest = scene;
  std::erase_if(rest.steps, [](const auto& step) { return step->needs_cavity(); });
  return rest;
}

/// The tools as the steps that make the cavity leave them. A scene that waits for a passage is taken to have
/// waited.
std::vector<ToolPose> poses_at_end(const Scene& scene, const Tooling& tooling) {
  std::vector<ToolPose> poses;
  for (const auto& tool : tooling.tools) {
    ToolPose pose;
    for (const auto& step : without_passages(scene).steps) {
      const auto tools = step->tools();
      const bool moved = std::find(tools.begin(), tools.end(), tool.spec.name) != tools.end();
      if (!moved || step->stays()) continue;
      const double kWithoutResistance = 1e3;  // s, of a tool under force control
      pose = compose(step->motion(step->duration().value_or(kWithoutResistance)), pose);
    }
    poses.push_back(pose);
  }
  return poses;
}

/// The part that powder is collected in: the first die, or the first that is no shoe. Throws SceneError when
/// there is none.
std::size_t die_of(const Scene& scene) {
  std::size_t best = scene.tools.size();
  for (std::size_t k = scene.tools.size(); k-- > 0;) {
    const ToolRole role = scene.tools[k].role;
    const bool better =
        best == scene.tools.size() || role == ToolRole::die || scene.tools[best].role != ToolRole::die;
    if (role != ToolRole::shoe && better) best = k;
  }
  if (best == scene.tools.size())
    throw SceneError(scene.file.string() +
                     ": tool: no die or plate to pour powder on; add a [[tool]] whose role is not shoe");
  return best;
}

/// Prepares steps that need the cavity; where there is none, the likeliest reason is told.
Scene prepare_passages(const Scene& scene, const Tooling& tooling, const std::vector<ToolPose>& poses) {
  try {
    return prepare_steps(scene, tooling, true);
  } catch (const SceneError& error) {
    if (tooling.cavity.found) throw;
    const std::string message = error.what(), remedy = "; give the distance";
    const auto end = std::min(message.find(remedy), message.size());
    throw SceneError(message.substr(0, end) + ": " + why_no_cavity(scene, tooling, poses) +
                     message.substr(end));
  }
}

/// Where tools stand that stay at their place in the long run, with the room they need about it.
void find_standing(const Scene& scene, Tooling& tooling) {
  const Stages stages(scene);
  const auto states = foreseen(stages, kSettlingGuess);
  const auto times = instants(stages, states, 200);
  const auto include = [&](const Tool& tool) {
    tooling.standing.include(tool.mesh.bounding_box());
    if (!stages.moves(tool.spec.name)) return;
    for (const double time : times)
      tooling.standing.include(moved_box(tool.mesh, pose_of(stages, states, tool.spec.name, time)));
  };
  for (const auto& tool : tooling.tools)
    if (tool.spec.role != ToolRole::shoe && stages.stays(tool.spec.name)) include(tool);
  if (tooling.standing.size().minCoeff() >= 0) return;
  for (const auto& tool : tooling.tools)
    if (tool.spec.role != ToolRole::shoe) include(tool);
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
void move_to_surface(geometry::WallSpheres& spheres, const geometry::SolidQuery& solid) {
  for (auto& centre : spheres.centres) centre = solid.nearest(centre).point;
  spheres.mean_deviation += spheres.radius;
  spheres.largest_deviation += spheres.radius;
}

bool is_mesh(const Scene& scene, const ToolSpec& spec) {
  return spec.walls.value_or(scene.walls.kind) == WallKind::mesh;
}

/// Covers the tool. Where the mesh is the wall, spheres only cut the cells of grains that measures take: in
/// sheet thinner than they are they are made as small as it needs.
geometry::WallSpheres spheres_of(const Scene& scene, const Tool& tool, double grain_diameter,
                                 geometry::WallSphereOptions options, const std::string& where) {
  constexpr double kShareOfSheet = 0.45;
  constexpr int kHalvings = 3;
  const auto& period = scene.numerics.period;
  const auto make = [&] {
    return period[0] || period[1]
               ? make_periodic_wall_spheres(tool.mesh, options, period, 2 * grain_diameter, where)
               : geometry::make_wall_spheres(tool.mesh, tool.solid(), options);
  };
  if (!is_mesh(scene, tool.spec)) return make();
  options.radius = std::min(options.radius, kShareOfSheet * geometry::mean_thickness(tool.mesh));
  for (int halving = 0; halving < kHalvings; ++halving, options.radius *= 0.5) try {
      return make();
    } catch (const geometry::MeshError&) {
      continue;
    }
  return make();
}

/// The tool's wall spheres; complaints about its geometry name the tool.
geometry::WallSpheres cover(const Scene& scene, const Tool& tool, double grain_diameter,
                            decltype(geometry::WallSphereOptions::reachable) reachable,
                            decltype(geometry::WallSphereOptions::tell) tell) {
  const std::string where = tool_in_words(scene, tool.spec);
  geometry::WallSphereOptions options;
  options.radius = sphere_radius(scene, tool.spec);
  options.spacing = tool.spec.spacing.value_or(scene.walls.spacing);
  options.reachable = std::move(reachable);
  options.tell = std::move(tell);
  try {
    auto spheres = spheres_of(scene, tool, grain_diameter, options, where);
    if (scene.numerics.opening == OpeningMeasure::centres) move_to_surface(spheres, tool.solid());
    keep_near_half(scene, spheres);
    return spheres;
  } catch (const geometry::MeshError& error) {
    const std::string message = error.what();
    const bool thin = message.find("thinner than a wall sphere") != std::string::npos;
    throw SceneError(where + ": " + message + (thin ? ", or set walls = \"mesh\" for this tool" : ""));
  }
}

/// The surface that powder meets where the mesh itself is the wall.
geometry::Mesh wall_mesh(const Scene& scene, const Tool& tool, double grain_diameter) {
  return periodic_wall_mesh(tool.mesh, scene.numerics.period, 4 * grain_diameter,
                            tool_in_words(scene, tool.spec));
}

void refuse_leaks(const Scene& scene, const Tool& tool, double smallest_radius) {
  if (tool.spheres.largest_gap < 2 * smallest_radius) return;
  char text[300];
  const Eigen::Vector3d place = tool.spheres.largest_gap_place * 1e3;
  std::snprintf(text, sizeof text,
                ": a sphere of a grain, %.4g mm in diameter, could pass the wall through a gap of %.4g mm "
                "near (%.2f, %.2f, %.2f) mm; reduce the spacing or the radius of the wall spheres",
                2e3 * smallest_radius, 1e3 * tool.spheres.largest_gap, place[0], place[1], place[2]);
  throw SceneError(tool_in_words(scene, tool.spec) + text);
}

}  // namespace

const geometry::SolidQuery& Tool::solid() const {
  if (!solid_ && topology_) {
    solid_.emplace(mesh, std::move(*topology_));
    topology_.reset();
  }
  if (!solid_) solid_.emplace(mesh);
  return *solid_;
}

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
                      tool.spec.file.filename().string() + " combined; use `part` to select one");
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
  pose.angular_velocity = motion.angular_velocity + motion.rotation * before.angular_velocity;
  pose.velocity = motion.velocity + motion.angular_velocity.cross(pose.translation - pivot) +
                  motion.rotation * before.velocity;
  return pose;
}

std::vector<geometry::Cavity> cavities_between(const Tooling& tooling, const std::vector<ToolPose>& poses) {
  const ToolPose& die = poses[tooling.die];
  std::vector<geometry::Mesh> moved;
  std::vector<const geometry::Mesh*> solids;
  moved.reserve(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (tooling.tools[k].spec.role == ToolRole::shoe) continue;
    const Eigen::Matrix3d rotation = die.rotation.transpose() * poses[k].rotation;
    const Eigen::Vector3d translation = die.rotation.transpose() * (poses[k].translation - die.translation);
    if (rotation == Eigen::Matrix3d::Identity() && translation.isZero(0)) {
      solids.push_back(&tooling.tools[k].mesh);
      continue;
    }
    moved.push_back(geometry::transformed(tooling.tools[k].mesh, rotation, translation));
    solids.push_back(&moved.back());
  }
  return geometry::find_cavities(solids, tooling.fill_plane);
}

geometry::Cavity cavity_between(const Tooling& tooling, const std::vector<ToolPose>& poses) {
  const auto cavities = cavities_between(tooling, poses);
  return cavities.empty() ? geometry::Cavity{} : cavities.front();
}

geometry::Cavity Tooling::all_cavities() const {
  geometry::Cavity together = cavity;
  for (const auto& other : other_cavities) {
    together.volume += other.volume;
    together.box.include(other.box);
    if (other.narrowest_width >= together.narrowest_width) continue;
    together.narrowest_width = other.narrowest_width;
    together.narrowest_place = other.narrowest_place;
  }
  return together;
}

Tooling read_tooling(const Scene& scene, const TellProgress& tell) {
  Tooling tooling;
  double bytes = 0, all_bytes = 0;
  for (const auto& spec : scene.tools) all_bytes += bytes_of(spec);
  for (const auto& spec : scene.tools) {
    tell(kToolsRead * bytes / all_bytes, "reading " + spec.file.filename().string());
    tooling.tools.push_back(read_tool(scene, spec));
    bytes += bytes_of(spec);
  }
  tell(kToolsRead, "checking how tools fit");
  for (const auto& tool : tooling.tools) refuse_unusable(scene, tool);
  try {
    refuse_misplaced(scene, tooling);
  } catch (const SceneError& error) {
    tooling.die = die_of(scene);
    const std::string unit = wrong_unit(scene, tooling);
    throw SceneError(error.what() + (unit.empty() ? "" : ", or: " + unit));
  }
  for (const auto& tool : tooling.tools) tooling.all.include(tool.mesh.bounding_box());
  tooling.die = die_of(scene);
  tooling.fill_plane =
      scene.measure.fill_plane.value_or(tooling.tools[tooling.die].mesh.bounding_box().upper.z());
  Scene followed = prepare_steps(scene, tooling, false);
  const auto poses = poses_at_end(followed, tooling);
  auto cavities = cavities_between(tooling, poses);
  if (!cavities.empty()) {
    tooling.cavity = cavities.front();
    tooling.other_cavities.assign(cavities.begin() + 1, cavities.end());
  }
  followed = prepare_passages(followed, tooling, poses);
  tooling.steps = followed.steps;
  refuse_endless_schedule(followed, tooling);
  refuse_collisions(followed, tooling);
  tooling.mirror = scene.economy.mirror;
  refuse_asymmetry(followed, tooling);
  carried_powder(followed, tooling);  // said now, before long work, where it cannot be
  find_standing(followed, tooling);
  return tooling;
}

Scene with_prepared_steps(Scene scene, const Tooling& tooling) {
  scene.steps = tooling.steps;
  return scene;
}

Tooling build_tooling(const Scene& as_read, double smallest_radius, double grain_diameter,
                      const TellProgress& tell) {
  refuse_endless(as_read);
  Tooling tooling = read_tooling(as_read, tell);
  const Scene scene = with_prepared_steps(as_read, tooling);
  tell(kToolsFit, "finding surfaces that powder can reach");
  const ReachableSurface reachable(scene, tooling, grain_diameter);
  const auto needs_wall = [&](std::size_t tool, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    return !scene.economy.skip_far_walls || reachable(tool, point, normal);
  };
  refuse_too_many_wall_spheres(scene, tooling, needs_wall);
  std::vector<CoverProgress::Part> parts;
  for (const Tool& tool : tooling.tools)
    parts.push_back({tool.spec.name, static_cast<double>(tool.mesh.triangles.size())});
  CoverProgress progress(parts);
  // Tools do not know of each other: they are covered side by side.
  std::vector<std::future<geometry::WallSpheres>> covered;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    covered.push_back(std::async(std::launch::async, [&, k] {
      return cover(
          scene, tooling.tools[k], grain_diameter,
          [&, k](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
            return needs_wall(k, point, normal);
          },
          [&, k](double share) { progress.done(k, share); });
    }));
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    Tool& tool = tooling.tools[k];
    tool.spheres = progress.wait_for(k, covered[k], kReachKnown, tell);
    if (is_mesh(scene, tool.spec))
      tool.wall_mesh = wall_mesh(scene, tool, grain_diameter);
    else
      refuse_leaks(scene, tool, smallest_radius);
  }
  return tooling;
}

}  // namespace diefill::process
