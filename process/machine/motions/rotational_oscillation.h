// Rotational oscillation about an axis (Bierwisch 2009, Eq. 6.1).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "process/machine/motions/oscillation.h"
#include "process/machine/rotation_axis.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

class RotationalOscillation final : public RampedMotion {
 public:
  RotationalOscillation(std::vector<std::string> tools, const RotationAxis& axis,
                        const Oscillation& oscillation)
      : RampedMotion(std::move(tools), oscillation.ramps), axis_(axis), oscillation_(oscillation) {}

  std::vector<double> turning_points(double length) const override {
    return oscillation_.turning_points(length);
  }
  std::string description() const override;

 private:
  ToolMotion at(double time, const Envelope& envelope) const override;

  RotationAxis axis_;
  Oscillation oscillation_;
};

/// Reads a step of kind "rotational oscillation".
std::shared_ptr<Step> read_rotational_oscillation(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
