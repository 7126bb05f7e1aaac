#include "process/tooling/tooling.h"

#include <stdexcept>
#include <utility>

namespace diefill::process {

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
    for (const auto& remark : tool.file_remarks) lines.push_back(name + ": " + remark);
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

double wall_sphere_radius(const Scene& scene, const ToolSpec& spec) {
  return spec.sphere_radius.value_or(scene.walls.sphere_radius);
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
  const ToolPose die = tooling.has_die() ? poses[tooling.die] : ToolPose();
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

Scene with_prepared_steps(Scene scene, const Tooling& tooling) {
  scene.steps = tooling.steps;
  return scene;
}

}  // namespace diefill::process
