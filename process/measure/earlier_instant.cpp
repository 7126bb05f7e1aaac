#include "process/measure/earlier_instant.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "process/measure/measure.h"
#include "process/results/formatted.h"
#include "process/results/instant_powder.h"
#include "process/results/moved_frame.h"

namespace diefill::process {
namespace {

std::string seconds(double time) {
  return results::formatted("%.4g s", time);
}

void refuse(const results::FillResult& result, double time) {
  if (result.instants.empty())
    throw std::invalid_argument(
        "the results contain only the end of the run (t = " + seconds(result.powder.time) +
        "); set measure.snapshot_interval in the scene and run it again to store earlier times");
  throw std::invalid_argument(
      "no instant near t = " + seconds(time) + ": the results contain " +
      std::to_string(result.instants.size()) + " from " + seconds(result.instants.front().time) + " to " +
      seconds(result.instants.back().time) + ", and the end at " + seconds(result.powder.time));
}

/// Null: that is the end. Throws as result_at() does.
const results::Instant* nearest_instant(const results::FillResult& result, double time) {
  const results::Instant* nearest = nullptr;
  double distance = std::abs(result.powder.time - time), spacing = 0.02 * result.powder.time;
  for (const auto& instant : result.instants) {
    if (std::abs(instant.time - time) < distance) {
      nearest = &instant;
      distance = std::abs(instant.time - time);
    }
  }
  if (result.instants.size() > 1) spacing = result.instants[1].time - result.instants[0].time;
  if (distance > spacing) refuse(result, time);
  return nearest;
}

Eigen::Matrix3d turn_of(const results::Instant& instant, std::size_t tool) {
  const Eigen::Vector4d& turn = instant.tool_orientation.at(tool);
  return Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).toRotationMatrix();
}

/// The die's frame at the instant, seen from the frame that the instant is kept in.
results::MovedFrame frame_of_die(const results::FillResult& result, const results::Instant& instant) {
  for (std::size_t n = 0; n < result.tools.size(); ++n)
    if (result.tools[n].role == "die") return {turn_of(instant, n), instant.tool_displacement.at(n)};
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
}

std::vector<results::ToolState> tools_at(const results::FillResult& result, const results::Instant& instant) {
  std::vector<results::ToolState> tools;
  for (std::size_t n = 0; n < result.tools.size(); ++n) tools.push_back(tool_at(result.tools[n], instant, n));
  return tools;
}

}  // namespace

results::ToolState tool_at(const results::ToolState& tool, const results::Instant& instant,
                           std::size_t number) {
  const Eigen::Matrix3d rotation = turn_of(instant, number);
  results::ToolState moved = tool;
  for (auto* points : {&moved.vertices, &moved.wall_sphere_centres})
    for (auto& point : *points) point = rotation * point + instant.tool_displacement.at(number);
  return moved;
}

results::FillResult result_at(const results::FillResult& result, double time, bool with_solid_fraction) {
  const results::Instant* nearest = nearest_instant(result, time);
  if (nearest == nullptr) return result;
  results::FillResult earlier = result;
  earlier.maps.clear();
  earlier.sections.clear();
  earlier.profiles.clear();
  earlier.contact_stress = {};  // is that of the end
  results::FillResult then = powder_at(result, *nearest, with_solid_fraction);
  earlier.powder = std::move(then.powder);
  earlier.tools = std::move(then.tools);
  earlier.solid_fraction = std::move(then.solid_fraction);
  if (with_solid_fraction)
    earlier.summary = summarise(earlier.powder, earlier.solid_fraction, earlier.cavity);
  return earlier;
}

results::FillResult film_frame_at(const results::FillResult& result, double time, bool with_solid_fraction) {
  results::FillResult frame = result_at(result, time, with_solid_fraction);
  const results::Instant* nearest = nearest_instant(result, time);
  if (nearest == nullptr || frame_of_die(result, *nearest).at_initial_pose()) return frame;
  frame.powder = results::powder_at(result.powder, *nearest);
  frame.tools = tools_at(result, *nearest);
  return frame;
}

results::FillResult powder_at(const results::FillResult& result, const results::Instant& instant,
                              bool with_solid_fraction) {
  const results::MovedFrame die = frame_of_die(result, instant);
  results::FillResult then;
  then.cavity = result.cavity;
  then.other_cavities = result.other_cavities;
  then.powder = die.powder(results::powder_at(result.powder, instant));
  then.tools = tools_at(result, instant);
  if (!die.at_initial_pose())
    for (auto& tool : then.tools)
      for (auto* points : {&tool.vertices, &tool.wall_sphere_centres})
        for (auto& point : *points) point = die.point(point);
  if (with_solid_fraction) then.solid_fraction = measure_solid_fraction(then.powder, then.tools, then.cavity);
  return then;
}

}  // namespace diefill::process
