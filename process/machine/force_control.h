// A tool moved by force or torque instead of along a prescribed path: PI control of its speed brings the
// powder's resistance to a target. Several targets may follow each other, with unloading between them; a
// rotor may also turn at a given speed until its torque is steady.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/rotation_axis.h"
#include "process/machine/steady_watch.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// State of a controlled tool. All that a restart needs.
struct ControlState {
  double coordinate = 0;     ///< m or rad at time `since`
  double rate = 0;           ///< m/s or rad/s from then on
  double integral = 0;       ///< m/s or rad/s, the integral part of the rate
  double since = 0;          ///< s
  std::uint64_t passed = 0;  ///< targets held for the pause; one more once the retreat is over
  double reached = -1;       ///< s, when the current target was reached; negative: not yet
  double turned_back = 0;    ///< m, coordinate where the latest target was left
  double load = 0;           ///< N or N m, resistance measured first
  double last = 0;           ///< N or N m, resistance measured last
  std::uint64_t updates = 0;
  SteadyWatch steady;

  double coordinate_at(double time) const { return coordinate + rate * (time - since); }
};

/// Targets and limits of the control. Units are those of a piston, in brackets those of a rotor.
struct ForceControl {
  static constexpr double kReached = 0.01;  ///< deviation over target below which it counts as reached
  static constexpr double kNear = 0.02;     ///< the same below which a piston's integral part acts

  bool turns = false;  ///< a torque about the axis, not a force along it
  RotationAxis axis;   ///< of pushing or turning
  /// N (N m), resistances of the powder to reach one after the other; none: the tool moves at the speed
  /// limit whatever the resistance.
  std::vector<double> targets;
  double speed_limit = 0;            ///< m/s (rad/s)
  double gain = 0.5;                 ///< speed without resistance over the speed limit
  double integral_time = 0;          ///< s
  double travel = 0;                 ///< m (rad), largest distance from the start
  double back = 0;                   ///< m (rad), largest distance behind the start
  std::optional<double> pause;       ///< s, hold of each target; nothing: the first without end
  double retreat = 0;                ///< m, way back after the last target
  bool ends_at_travel = false;       ///< the step ends after `travel`
  std::optional<SteadyRule> steady;  ///< the step ends once the resistance is steady

  /// Whether the step ends without a given duration.
  bool ends_by_itself() const { return pause || ends_at_travel || steady; }
  /// N (N m), the current target; 0 where the tool moves at a given speed.
  double wanted(const ControlState& state) const;
  double largest_target() const;
  /// Whether the step is over: all targets were held and the retreat is over, the tool has gone its travel,
  /// or its resistance is steady.
  bool done(const ControlState& state) const;
  /// Whether the tool has gone all the way that it has while the powder bears less, or more, than the target.
  bool is_at_its_limit(const ControlState& state) const;
  /// The powder's resistance, N (N m), to a body on which it acts with `force` (N) and `torque` (N m, about
  /// `place`, m).
  double resistance(const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                    const Eigen::Vector3d& place) const;
  /// Advances `state` to `now` (s) and sets its rate for the next `interval` s, from the mean `measured`
  /// resistance since the last call.
  void update(ControlState& state, double measured, double now, double interval) const;
  ToolMotion motion(double coordinate, double rate) const;

 private:
  double scale(const ControlState& state) const;
  void pass_targets(ControlState& state, double measured, double now) const;
  double requested_rate(ControlState& state, double measured, double interval) const;
};

/// A tool under force control. motion(), which tells where the tool can get to, is that without resistance.
class ControlledTool final : public Step {
 public:
  ControlledTool(std::vector<std::string> tools, const ForceControl& control, std::optional<double> duration)
      : tools_(std::move(tools)), control_(control), duration_(duration) {}

  std::vector<std::string> tools() const override { return tools_; }
  bool open_ended() const override { return !duration_ && !control_.ends_by_itself(); }
  std::optional<double> duration() const override { return duration_; }
  bool stays() const override { return control_.turns; }
  ToolMotion motion(double time) const override;
  double stopping_time(double) const override { return 0; }
  const ForceControl* control() const override { return &control_; }
  std::string description() const override;

 private:
  std::vector<std::string> tools_;
  ForceControl control_;
  std::optional<double> duration_;
};

/// Reads a step of kind "piston": force control along a line.
std::shared_ptr<Step> read_piston(TableReader& table, const std::vector<ToolSpec>& tools);
/// Reads a step of kind "rotor": torque control about an axis, or a given speed until the torque is steady.
std::shared_ptr<Step> read_rotor(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
