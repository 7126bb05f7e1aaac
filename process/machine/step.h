// One motion or action of the machine: settle, a shoe passage, a vibration, ... A step states its duration
// and the displacement of its tools as functions of the time since it began, so a restart needs only the
// times at which it started and was stopped.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/standard_gravity.h"
#include "process/machine/condition.h"

namespace diefill::process {

/// Displacement of a tool by one step, from where the other steps leave it: first turned about `pivot`, then
/// shifted.
struct ToolMotion {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< m
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();      ///< turns about `pivot`
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();             ///< m, laboratory frame
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s, of the pivot
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame
};

/// What a step may use of the scene when it is prepared for a run.
struct MachineContext {
  Eigen::Vector3d cavity_lower = Eigen::Vector3d::Zero(),
                  cavity_upper = Eigen::Vector3d::Zero();  ///< m; empty if equal
  /// m, box of the step's tools, walls included, where earlier steps leave them.
  Eigen::Vector3d tool_lower = Eigen::Vector3d::Zero(), tool_upper = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity = {0, 0, -engine::kStandardGravity};  ///< m/s^2
};

/// What any step of the scene may state besides its kind's own keys.
struct StepPlan {
  std::string name;                ///< empty: it is not referred to
  std::optional<Condition> start;  ///< nothing: when the step before it in the scene has ended
  std::optional<Condition> until;  ///< nothing: as long as it takes by itself
  std::string where;               ///< place in the scene file, for messages
};

struct ForceControl;   // force_control.h
struct PowderInflow;   // powder_inflow.h
struct PowderRemoval;  // clear.h
struct PowderChange;   // powder_change.h

/// One step of the schedule.
class Step {
 public:
  virtual ~Step() = default;
  /// True if the step needs the cavity and the position of its tools; it is then prepared after all others.
  virtual bool needs_cavity() const { return false; }
  /// The step with all that depends on the geometry resolved, such as the travel of a passage; null where
  /// nothing depends on it. Throws SceneError when the geometry allows no sensible answer.
  virtual std::shared_ptr<const Step> prepared(const MachineContext&) const { return nullptr; }
  /// Names of the tools that move, all in the same way; empty when none does.
  virtual std::vector<std::string> tools() const { return {}; }
  /// True if the step's duration is open: it lasts until its plan says, or until the powder is at rest.
  virtual bool open_ended() const { return false; }
  /// s, or nothing when it is open.
  virtual std::optional<double> duration() const = 0;
  /// True for motions about one place, such as shaking: on average the tool stays where it is.
  virtual bool stays() const { return false; }
  /// s since the step began: instants at which such a motion, lasting `length` s, is farthest out on either
  /// side. Empty where the kind does not know them.
  virtual std::vector<double> turning_points(double length) const {
    (void)length;
    return {};
  }
  /// Motion of the tools at `time` (s since the step began), relative to where the other steps leave them.
  /// Requested from 0 to the duration only.
  virtual ToolMotion motion(double time) const {
    (void)time;
    return {};
  }
  /// s that the step needs to come to rest after it is stopped `stop` s after it began.
  virtual double stopping_time(double stop) const;
  /// Motion of a step that was stopped at `stop` (s since it began). By default it continues along its
  /// path ever more slowly.
  virtual ToolMotion motion_stopped(double time, double stop) const;
  /// A step under force control, whose path depends on the powder's resistance. Otherwise null.
  virtual const ForceControl* control() const { return nullptr; }
  /// Powder that enters while the step is active. Otherwise null.
  virtual const PowderInflow* inflow() const { return nullptr; }
  /// Powder that is removed when the step begins. Otherwise null.
  virtual const PowderRemoval* removal() const { return nullptr; }
  /// What acts otherwise from the step's begin on. Otherwise null.
  virtual const PowderChange* change() const { return nullptr; }
  /// For titles and progress, such as "2 passages at 0.2 m/s".
  virtual std::string description() const = 0;

  StepPlan plan;
};

}  // namespace diefill::process
