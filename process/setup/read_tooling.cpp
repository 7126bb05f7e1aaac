#include "process/setup/read_tooling.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "process/setup/averaging_width_limit.h"
#include "process/setup/predicted_work.h"
#include "process/tooling/co_moving_powder.h"
#include "process/tooling/cover_progress.h"
#include "process/tooling/examination/no_cavity.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/half_model.h"
#include "process/tooling/stages.h"
#include "process/tooling/tool_paths.h"

namespace diefill::process {

namespace {

/// More than 0; errors of files that cannot be read are reported when they are read.
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

/// m, of the part that powder is collected in, in the frame that cavities are found in.
double highest_point(const Tooling& tooling, const std::vector<ToolPose>& poses) {
  const ToolPose still;
  return moved_box(tooling.tools[tooling.die].mesh, tooling.has_die() ? still : poses[tooling.die]).upper.z();
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

/// Space taken up by tools that keep their mean position, including their motion about it.
void find_standing(const Scene& scene, Tooling& tooling) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
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

void refuse_misplaced(const Scene& scene, const Tooling& tooling) {
  for (std::size_t k = 0; k < tooling.tools.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      check_fit(tooling.tools[k], tooling.tools[other], wall_sphere_radius(scene, tooling.tools[k].spec),
                tool_text(scene, tooling.tools[k].spec));
}

}  // namespace

Tooling read_tooling(const Scene& scene, const ProgressCallback& on_progress) {
  Tooling tooling;
  double bytes = 0, all_bytes = 0;
  for (const auto& spec : scene.tools) all_bytes += bytes_of(spec);
  for (const auto& spec : scene.tools) {
    on_progress(kToolsReadShare * bytes / all_bytes, "reading " + spec.file.filename().string());
    tooling.tools.push_back(read_tool(scene, spec));
    bytes += bytes_of(spec);
  }
  on_progress(kToolsReadShare, "checking how tools fit");
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
  Scene followed = prepare_steps(scene, tooling, false);
  const auto poses = poses_at_end(followed, tooling);
  tooling.fill_plane = scene.measure.fill_plane.value_or(highest_point(tooling, poses));
  auto cavities = cavities_between(tooling, poses);
  if (!cavities.empty()) {
    tooling.cavity = cavities.front();
    tooling.other_cavities.assign(cavities.begin() + 1, cavities.end());
  }
  refuse_wide_averaging(scene, tooling);
  followed = prepare_passages(followed, tooling, poses);
  tooling.steps = followed.steps;
  refuse_excessive_schedule(followed, tooling);
  refuse_collisions(followed, tooling);
  tooling.mirror = scene.economy.mirror;
  refuse_asymmetry(followed, tooling);
  co_moving_powder(followed, tooling);  // said now, before long work, where it cannot be
  find_standing(followed, tooling);
  return tooling;
}

}  // namespace diefill::process
