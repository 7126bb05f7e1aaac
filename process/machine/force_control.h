// A tool that follows the powder's resistance instead of a prescribed path: pushed with a given force, or
// turned with a given torque, by PI control of its speed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/rotation_axis.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// State of a controlled tool. All that a restart needs.
struct ControlState {
  double coordinate = 0;  ///< m or rad at time `since`
  double rate = 0;        ///< m/s or rad/s from then on
  double integral = 0;    ///< m/s or rad/s, the integral part of the rate
  double since = 0;       ///< s

  double coordinate_at(double time) const { return coordinate + rate * (time - since); }
};

/// Target and limits of the control. Units of a line, with those of a rotation in brackets.
struct ForceControl {
  bool turns = false;        ///< a torque about the axis, not a force along it
  RotationAxis axis;         ///< of pushing or turning
  double target = 0;         ///< N (N m), wanted resistance of the powder
  double speed_limit = 0;    ///< m/s (rad/s)
  double acceleration = 10;  ///< m/s^2 (rad/s^2), at most
  double gain = 0;           ///< m/s per N (rad/s per N m), proportional part
  double integral_time = 0;  ///< s
  double travel = 0;         ///< m (rad), farthest from the start; never goes back behind the start

  /// The powder's resistance, N (N m), to a body on which it acts with `force` (N) and `torque` (N m, about
  /// `place`, m).
  double resistance(const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                    const Eigen::Vector3d& place) const;
  /// Advances `state` to `now` (s) and sets its rate for the next `interval` s, from the mean `measured`
  /// resistance since the last call. The integral is held while the speed limit acts.
  void update(ControlState& state, double measured, double now, double interval) const;
  ToolMotion motion(double coordinate, double rate) const;
};

/// A tool under force control. Its motion as a function of time, used to see what it can reach, is that
/// without any resistance.
class ControlledTool final : public Step {
 public:
  ControlledTool(std::vector<std::string> tools, const ForceControl& control, std::optional<double> duration)
      : tools_(std::move(tools)), control_(control), duration_(duration) {}

  std::vector<std::string> tools() const override { return tools_; }
  bool open_ended() const override { return !duration_; }
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
/// Reads a step of kind "rotor": torque control about an axis.
std::shared_ptr<Step> read_rotor(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
