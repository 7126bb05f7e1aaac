// Steady turning about an axis, as of a stirrer or a mixer, that starts and stops smoothly.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/machine/rotational_oscillation.h"

namespace diefill::process {

/// What a rotation is told by the scene. SI units.
struct RotationSpec {
  std::vector<std::string> tools;
  RotationAxis axis;
  double speed = 0;                ///< rad/s, right-handed; negative: the other way round
  double ramp = 0.1;               ///< s of starting and of stopping
  std::optional<double> duration;  ///< s, ramps included; nothing: until told to stop
};

class Rotation final : public Step {
 public:
  explicit Rotation(RotationSpec spec) : spec_(std::move(spec)) {}

  std::vector<std::string> tools() const override { return spec_.tools; }
  bool open_ended() const override { return !spec_.duration; }
  std::optional<double> duration() const override { return spec_.duration; }
  bool stays() const override { return true; }
  ToolMotion motion(double time) const override;
  double stopping_time(double stop) const override;
  ToolMotion motion_stopped(double time, double stop) const override;
  std::string in_words() const override;

 private:
  Envelope envelope(double stop) const;

  RotationSpec spec_;
};

/// Reads a step of kind "rotation".
std::shared_ptr<Step> read_rotation(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
