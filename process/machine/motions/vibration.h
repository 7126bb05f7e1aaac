// Shaking along an axis (Bierwisch 2009, section 6.5.2).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "process/machine/motions/oscillation.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

class Vibration final : public RampedMotion {
 public:
  /// `axis` is a unit vector.
  Vibration(std::vector<std::string> tools, const Eigen::Vector3d& axis, const Oscillation& oscillation)
      : RampedMotion(std::move(tools), oscillation.ramps), axis_(axis), oscillation_(oscillation) {}

  std::vector<double> turning_points(double length) const override {
    return oscillation_.turning_points(length);
  }
  std::string description() const override;

 private:
  ToolMotion at(double time, const Envelope& envelope) const override;

  Eigen::Vector3d axis_;
  Oscillation oscillation_;
};

/// Reads a step of kind "vibration".
std::shared_ptr<Step> read_vibration(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
