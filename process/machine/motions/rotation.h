// Steady turning about an axis, as of a stirrer or a mixer, that starts and stops smoothly.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "process/machine/motions/ramped_motion.h"
#include "process/machine/rotation_axis.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

class Rotation final : public RampedMotion {
 public:
  /// `speed` in rad/s, right-handed; negative: the other way round.
  Rotation(std::vector<std::string> tools, const RotationAxis& axis, double speed, const RampTimes& ramps)
      : RampedMotion(std::move(tools), ramps), axis_(axis), speed_(speed) {}

  std::string description() const override;

 private:
  ToolMotion at(double time, const Envelope& envelope) const override;

  RotationAxis axis_;
  double speed_;
};

/// Reads a step of kind "rotation".
std::shared_ptr<Step> read_rotation(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
