// Turning to and fro about an axis: phi(t) = e(t) phi_0 sin(2 pi f t + phi) (Bierwisch 2009, Eq. 6.1, with an
// envelope e that swells and dies away).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/machine/step.h"
#include "process/machine/vibration.h"
#include "process/scene/scene.h"
#include "process/scene/table_reader.h"

namespace diefill::process {

/// A straight line that tools turn about; `through` in m, laboratory frame.
struct RotationAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(), through = Eigen::Vector3d::Zero();

  /// The motion turned by `angle` (rad, right-handed) and turning at `rate` (rad/s).
  ToolMotion turned(double angle, double rate) const;
};

/// Reads `axis` (z unless given) and `through` (the origin unless given).
RotationAxis read_rotation_axis(TableReader& table);

class RotationalOscillation final : public Step {
 public:
  RotationalOscillation(std::vector<std::string> tools, const RotationAxis& axis,
                        const Oscillation& oscillation)
      : tools_(std::move(tools)), axis_(axis), oscillation_(oscillation) {}

  std::vector<std::string> tools() const override { return tools_; }
  bool open_ended() const override { return !oscillation_.duration; }
  std::optional<double> duration() const override { return oscillation_.duration; }
  bool stays() const override { return true; }
  ToolMotion motion(double time) const override;
  double stopping_time(double stop) const override;
  ToolMotion motion_stopped(double time, double stop) const override;
  std::string in_words() const override;

 private:
  ToolMotion at(double time, const Envelope& envelope) const;

  std::vector<std::string> tools_;
  RotationAxis axis_;
  Oscillation oscillation_;
};

/// Reads a step of kind "rotational oscillation".
std::shared_ptr<Step> read_rotational_oscillation(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
