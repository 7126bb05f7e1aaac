// One thing the machine does: settle, a shoe passage, a vibration, ... A step knows how long it takes and
// where it carries its tools, as functions of the time since it began, so that a restart needs no history but
// the times of its start and of being told to stop.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// What a step may ask about the scene when it is prepared for a run.
struct MachineContext {
  Eigen::Vector3d cavity_lower = Eigen::Vector3d::Zero(),
                  cavity_upper = Eigen::Vector3d::Zero();  ///< m; empty if equal
  /// m, box of the step's tools, walls included, where earlier steps leave them.
  Eigen::Vector3d tool_lower = Eigen::Vector3d::Zero(), tool_upper = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity = {0, 0, -9.81};  ///< m/s^2
};

/// What any step of the scene may say besides its kind's own keys.
struct StepPlan {
  std::string name;                ///< empty: nobody refers to it
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
  /// True if the step must know the cavity and where its tools stand; it is then prepared after all others.
  virtual bool needs_cavity() const { return false; }
  /// The step with whatever depends on the geometry settled, such as how far a passage has to go; null where
  /// the step can be followed as it stands. Throws SceneError when the geometry leaves no sensible answer.
  virtual std::shared_ptr<const Step> prepared(const MachineContext&) const { return nullptr; }
  /// Names of the tools that move, all alike; empty when none does.
  virtual std::vector<std::string> tools() const { return {}; }
  /// True if the step's duration is left open: it lasts until its plan says, or until the powder is at rest.
  virtual bool open_ended() const { return false; }
  /// s, or nothing when it is left open.
  virtual std::optional<double> duration() const = 0;
  /// True for motions about one place, such as shaking: the tool stays where it is, in the long run.
  virtual bool stays() const { return false; }
  /// s since the step began: instants at which such a motion, lasting `length` s, is farthest out to either
  /// side. Empty where the kind does not know them.
  virtual std::vector<double> turning_points(double length) const {
    (void)length;
    return {};
  }
  /// Motion of the tools at `time` (s since the step began), added to where the other steps leave them.
  /// Asked from 0 to the duration only.
  virtual ToolMotion motion(double time) const {
    (void)time;
    return {};
  }
  /// s that the step needs to come to a stand after it is told to stop `stop` s after it began.
  virtual double stopping_time(double stop) const;
  /// Motion of a step that was told to stop at `stop` (s since it began). Unless a kind knows better, it goes
  /// on along its way ever more slowly.
  virtual ToolMotion motion_stopped(double time, double stop) const;
  /// A step whose way is not known beforehand: it is driven by the powder's resistance. Otherwise null.
  virtual const ForceControl* control() const { return nullptr; }
  /// Powder that comes in while the step is on. Otherwise null.
  virtual const PowderInflow* inflow() const { return nullptr; }
  /// Powder that is taken away when the step begins. Otherwise null.
  virtual const PowderRemoval* removal() const { return nullptr; }
  /// What acts otherwise from the step's begin on. Otherwise null.
  virtual const PowderChange* change() const { return nullptr; }
  /// For titles and progress, such as "2 passages at 0.2 m/s".
  virtual std::string description() const = 0;

  StepPlan plan;
};

}  // namespace diefill::process
