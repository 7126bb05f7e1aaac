// Common part of vibrations, oscillations and rotations: tools that move about one place, with a ramp at the
// beginning and at the end or when stopped.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/smooth_ramp.h"
#include "process/machine/step.h"

namespace diefill::process {

/// How long such a motion lasts. SI units.
struct RampTimes {
  double ramp = 0;                 ///< s of ramping up and of ramping down
  std::optional<double> duration;  ///< s, ramps included; nothing: until stopped

  /// Envelope of a motion that is stopped at `stop` s; infinite: never.
  Envelope envelope(double stop) const;
};

/// Reads `ramp` (s, `ramp` unless given) and `duration`. Throws SceneError where a duration is too short for
/// both ramps.
RampTimes read_ramps(TableReader& table, double ramp);

class RampedMotion : public Step {
 public:
  RampedMotion(std::vector<std::string> tools, const RampTimes& ramps)
      : tools_(std::move(tools)), ramps_(ramps) {}

  std::vector<std::string> tools() const override { return tools_; }
  bool open_ended() const override { return !ramps_.duration; }
  std::optional<double> duration() const override { return ramps_.duration; }
  bool stays() const override { return true; }
  ToolMotion motion(double time) const override;
  double stopping_time(double stop) const override;
  ToolMotion motion_stopped(double time, double stop) const override;

 private:
  /// Motion at `time` (s since the step began) under `envelope`.
  virtual ToolMotion at(double time, const Envelope& envelope) const = 0;

  std::vector<std::string> tools_;
  RampTimes ramps_;
};

}  // namespace diefill::process
