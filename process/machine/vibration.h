// Shaking along an axis: u(t) = e(t) A sin(2 pi f t + phi) with an envelope e that swells and dies away
// (Bierwisch 2009, section 6.5.2).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/machine/smooth_ramp.h"
#include "process/machine/step.h"
#include "process/scene/scene.h"
#include "process/scene/table_reader.h"

namespace diefill::process {

/// An oscillation in time, of whatever quantity. SI units.
struct Oscillation {
  double amplitude = 0;            ///< m or rad
  double frequency = 0;            ///< Hz
  double phase = 0;                ///< rad
  double ramp = 0;                 ///< s of swelling and of dying away
  std::optional<double> duration;  ///< s, ramps included; nothing: until told to stop

  /// Envelope of an oscillation told to stop at `stop` s.
  Envelope envelope(double stop) const;
  double value(double time, const Envelope& envelope) const;  ///< m or rad
  double rate(double time, const Envelope& envelope) const;   ///< m/s or rad/s
};

/// Reads `frequency`, `phase`, `ramp` (one period unless given) and `duration`. Throws SceneError.
void read_oscillation(TableReader& table, Oscillation& oscillation);

class Vibration final : public Step {
 public:
  /// `axis` is a unit vector.
  Vibration(std::vector<std::string> tools, const Eigen::Vector3d& axis, const Oscillation& oscillation)
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
  Eigen::Vector3d axis_;
  Oscillation oscillation_;
};

/// Reads a step of kind "vibration".
std::shared_ptr<Step> read_vibration(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
