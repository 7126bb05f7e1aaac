// Whether powder that steps let in has room to come.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/powder/sphere_volume.h"
#include "process/machine/actions/powder_change.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/powder/random.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/half_model.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr int kTries = 400, kAtLast = 20000;  // places in a box that are tried
constexpr int kTimes = 5;                     // instants of a step
constexpr double kRandomPacking =
    0.38;  // share that spheres dropped at random take of a box (random addition)

/// Share of the box in which a grain has room at one instant.
double room_at(const Tooling& tooling, const PowderInflow& inflow, const Stages& stages,
               const std::vector<StepState>& states, double time, double radius, int tries = kTries) {
  std::vector<ToolPose> poses;
  for (const Tool& tool : tooling.tools) poses.push_back(pose_of(stages, states, tool.spec.name, time));
  const ToolPose carrier = inflow.with.empty() ? ToolPose{} : poses[tooling.index_of(inflow.with)];
  const geometry::Box box = start_box(tooling, inflow, radius);
  const Eigen::Vector3d middle = 0.5 * (box.lower + box.upper), half = 0.5 * box.size();
  Random random(1);
  int free = 0;
  for (int n = 0; n < tries; ++n) {
    const Eigen::Vector3d offset(random.symmetric(), random.symmetric(), random.symmetric());
    const Eigen::Vector3d own = middle + offset.cwiseProduct(half);
    const Eigen::Vector3d place = carrier.rotation * own + carrier.translation;
    bool clear = true;
    for (std::size_t k = 0; clear && k < poses.size(); ++k)
      clear = tooling.tools[k].solid().signed_distance(poses[k].rotation.transpose() *
                                                       (place - poses[k].translation)) >= radius;
    free += clear ? 1 : 0;
  }
  return static_cast<double>(free) / tries;
}

/// The largest of such shares while the step is active.
double largest_room(const Tooling& tooling, const PowderInflow& inflow, const Stages& stages,
                    const std::vector<StepState>& states, const StepState& state, double radius) {
  double room = 0;
  for (int n = 0; n < kTimes; ++n)
    room = std::max(room, room_at(tooling, inflow, stages, states,
                                  state.started + (state.ended - state.started) * n / (kTimes - 1), radius));
  return room > 0 ? room : room_at(tooling, inflow, stages, states, state.started, radius, kAtLast);
}

std::string box_text(const PowderInflow& inflow) {
  char text[200];
  const Eigen::Vector3d from = 1e3 * inflow.lower, to = 1e3 * inflow.upper;
  std::snprintf(text, sizeof text, "the box from (%.4g, %.4g, %.4g) to (%.4g, %.4g, %.4g) mm", from.x(),
                from.y(), from.z(), to.x(), to.y(), to.z());
  return text;
}

/// m, bounding radius of the largest grains that the step lets in.
double largest_radius(const Scene& scene, const PowderInflow& inflow) {
  const auto types = particle_types(scene);
  const auto shares = number_shares(scene, inflow);
  double largest = 0;
  for (std::size_t k = 0; k < types.size(); ++k)
    if (shares[k].number_share > 0) largest = std::max(largest, types[k].shape.bounding_radius());
  return largest;
}

/// In a half model every grain must have room between the mirror plane and the border of the box.
void refuse_narrow_half(const Scene& scene, const Tooling& tooling, const PowderInflow& inflow,
                        const std::string& step) {
  if (!tooling.mirror) return;
  const double radius = largest_radius(scene, inflow), width = inflow.upper[*tooling.mirror];
  if (width >= radius) return;
  const char axis = *tooling.mirror == 0 ? 'x' : 'y';
  char text[200];
  std::snprintf(
      text, sizeof text,
      " reaches %.4g mm beyond the mirror plane %c = 0, but a grain needs %.4g mm, its radius; widen "
      "the box along %c or remove economy.mirror",
      1e3 * width, axis, 1e3 * radius, axis);
  throw SceneError(step + ": " + box_text(inflow) + text);
}

/// m/s^2, the largest magnitude of gravity while a step in `of` is active: as the latest step that began
/// before or with it left it, or as one sets it meanwhile.
double gravity_during(const Scene& scene, const std::vector<StepState>& states, const StepState& of) {
  double at_start = scene.gravity.norm(), meanwhile = 0, latest = -1;
  for (std::size_t k = 0; k < scene.steps.size(); ++k) {
    const PowderChange* change = scene.steps[k]->change();
    const double time = states[k + 1].started;
    if (change == nullptr || !change->gravity || time < 0) continue;
    if (time > of.started && time < of.ended)
      meanwhile = std::max(meanwhile, change->gravity->norm());
    else if (time <= of.started && time >= latest)
      latest = time, at_start = change->gravity->norm();
  }
  return std::max(at_start, meanwhile);
}

/// kg/s for which grains that fall out of the box under gravity `g` (m/s^2) make room.
double largest_rate(const Scene& scene, const PowderInflow& inflow, double share, double g) {
  const double across = 2 * mean_grain(scene).bounding_radius();
  const Eigen::Vector3d size = (inflow.upper - inflow.lower).cwiseMax(across);
  const double grain = engine::sphere_volume_of_diameter(across);
  const double held = std::max(1.0, kRandomPacking * share * size.prod() / grain) * mean_grain(scene).mass;
  const double height = size.z(), speed = std::abs(inflow.velocity.z());
  const double time = 2 * height / (std::sqrt(speed * speed + 2 * g * height) + speed);
  return held / time;
}

}  // namespace

std::vector<SetupFinding> inflow_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  const bool any = std::any_of(scene.steps.begin(), scene.steps.end(),
                               [](const auto& step) { return step->inflow() != nullptr; });
  if (!any) return findings;
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  for (std::size_t k = 0; k < scene.steps.size(); ++k) {
    const PowderInflow* inflow = scene.steps[k]->inflow();
    if (inflow == nullptr) continue;
    const StepState& state = states[k + 1];
    const std::string step = scene.steps[k]->plan.where;
    refuse_narrow_half(scene, tooling, *inflow, step);
    const double room =
        largest_room(tooling, *inflow, stages, states, state, mean_grain(scene).bounding_radius());
    const Eigen::Vector3d middle = 0.5 * (inflow->lower + inflow->upper);
    if (room == 0)
      throw SceneError(step + ": " + box_text(*inflow) +
                       " lies inside a tool or leaves no space for a grain between tools, so no powder can "
                       "enter; move it");
    if (!inflow->rate) continue;
    const double most = largest_rate(scene, *inflow, room, gravity_during(scene, states, state));
    if (*inflow->rate <= most) continue;
    char text[300];
    std::snprintf(
        text, sizeof text,
        "rate is %.4g g/s, but %s delivers at most about %.2g g/s, as fast as grains fall out of it: powder "
        "will enter more slowly; enlarge the box, give the grains a velocity, or reduce the rate",
        1e3 * *inflow->rate, box_text(*inflow).c_str(), 1e3 * most);
    findings.push_back({step + ": " + text, {middle}});
  }
  return findings;
}

}  // namespace diefill::process
