#include "process/run/kept_instants.h"

#include <Eigen/Geometry>
#include <utility>

#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"

namespace diefill::process {
namespace {

engine::BodyMotion pose_of_tool(const results::Instant& instant, std::size_t tool) {
  const Eigen::Vector4d& turned = instant.tool_orientation[tool];
  engine::BodyMotion pose;
  pose.rotation = Eigen::Quaterniond(turned[0], turned[1], turned[2], turned[3]).toRotationMatrix();
  pose.translation = instant.tool_displacement[tool];
  return pose;
}

/// From places of tools in the results to those at the instant, in the frame `then`.
void set_tools(results::Instant& instant, const engine::Simulation& simulation, const DieFrame& at_end,
               const DieFrame& then) {
  for (std::size_t b = 0; b < instant.tool_orientation.size(); ++b) {
    const engine::BodyMotion pose = then.pose(pose_of_tool(instant, b)),
                             end = at_end.pose(simulation.body_motion(b));
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(pose.rotation) * Eigen::Quaterniond(end.rotation).conjugate();
    instant.tool_orientation[b] = {turn.w(), turn.x(), turn.y(), turn.z()};
    instant.tool_displacement[b] = pose.translation - turn * end.translation;
  }
}

}  // namespace

std::vector<results::Instant> kept_instants(const Tooling& tooling, const FillRun& run,
                                            const results::PowderState& powder) {
  const DieFrame at_end = die_frame(run.simulation(), tooling);
  std::vector<results::Instant> instants = run.instants();
  for (auto& instant : instants) {
    const DieFrame then = at_end.at_initial_pose() ? at_end : DieFrame(pose_of_tool(instant, tooling.die));
    add_images(tooling, powder, instant);
    instant = then.powder(std::move(instant));
    set_tools(instant, run.simulation(), at_end, then);
  }
  return instants;
}

}  // namespace diefill::process
