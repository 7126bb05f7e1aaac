// One thing the machine does: settle, a shoe passage, ... A step knows how long it takes and where it carries
// its tool, as functions of the time since it began, so that a restart needs no history but the time of its
// start.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>

namespace diefill::process {

/// Where a tool stands and how it moves, relative to its pose in the scene. Rotation is about `pivot`.
struct ToolMotion {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< m
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();      ///< turns about `pivot`
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();             ///< m, laboratory frame
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s, of the pivot
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame
};

/// What a step may ask about the scene when the run prepares it.
struct MachineContext {
  Eigen::Vector3d cavity_lower = Eigen::Vector3d::Zero(),
                  cavity_upper = Eigen::Vector3d::Zero();  ///< m; empty if equal
  /// m, box of the step's tool, walls included, where earlier steps leave it.
  Eigen::Vector3d tool_lower = Eigen::Vector3d::Zero(), tool_upper = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity = {0, 0, -9.81};  ///< m/s^2
};

/// One step of the schedule.
class Step {
 public:
  virtual ~Step() = default;
  /// Settles whatever depends on the geometry, such as how far a passage has to go. Called once, before the
  /// run. Throws SceneError when the geometry leaves no sensible answer.
  virtual void prepare(const MachineContext&) {}
  /// Name of the tool that moves; empty when none does.
  virtual std::string tool() const { return {}; }
  /// s, or nothing when the step lasts until the powder is at rest.
  virtual std::optional<double> duration() const = 0;
  /// Motion of the tool at `time` (s since the step began), added to where earlier steps left it.
  virtual ToolMotion motion(double time) const {
    (void)time;
    return {};
  }
  /// For titles and progress, such as "2 passages at 0.2 m/s".
  virtual std::string in_words() const = 0;
};

}  // namespace diefill::process
