// A tool that follows the powder's resistance instead of a prescribed path: pushed with a given force, or
// turned with a given torque, by PI control of its speed. It may seek several of them in turn, and unload
// between them; a rotor may also turn at a given speed, until its torque is steady.
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
  std::uint64_t passed = 0;  ///< targets that were held long enough; one more after the retreat
  double reached = -1;       ///< s, when the present target was; negative: not yet
  double turned_back = 0;    ///< m, coordinate where the last target was left
  double load = 0;           ///< N or N m, the first resistance that was measured
  double last = 0;           ///< N or N m, the one before the present
  std::uint64_t updates = 0;
  SteadyWatch steady;

  double coordinate_at(double time) const { return coordinate + rate * (time - since); }
};

/// Targets and limits of the control. Units of a line, with those of a rotation in brackets.
struct ForceControl {
  static constexpr double kReached = 0.01;  ///< of a target: as near as this it counts as reached
  static constexpr double kNear = 0.02;     ///< of a target: the integral part of a piston acts within this

  bool turns = false;  ///< a torque about the axis, not a force along it
  RotationAxis axis;   ///< of pushing or turning
  /// N (N m), wanted resistance of the powder, one after the other; none: it moves at the speed limit,
  /// whatever the powder resists.
  std::vector<double> targets;
  double speed_limit = 0;       ///< m/s (rad/s)
  double gain = 0.5;            ///< speed without resistance over the speed limit
  double integral_time = 0;     ///< s
  double travel = 0;            ///< m (rad), farthest from the start
  double back = 0;              ///< m (rad), farthest behind the start
  std::optional<double> pause;  ///< s for which each target is held; nothing: the first one is held for ever
  double retreat = 0;           ///< m, way back after the last one
  bool ends_at_travel = false;  ///< over once it has gone that far
  std::optional<SteadyRule> steady;  ///< over once its resistance is steady

  /// Whether it ends without being stopped.
  bool ends_by_itself() const { return pause || ends_at_travel || steady; }
  /// The target that is sought or held; 0 where it moves at a given speed.
  double wanted(const ControlState& state) const;
  double largest_target() const;
  /// Whether all targets were held and the way back is over, it has gone as far as it should, or its
  /// resistance is steady.
  bool done(const ControlState& state) const;
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

/// A tool under force control. Its motion as a function of time, used to see what it can reach, is that
/// without any resistance.
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
