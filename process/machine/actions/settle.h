// Nothing moves but the powder, until it rests or for a given time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

class Settle final : public Step {
 public:
  /// `duration` in s; without one the step lasts until the powder is at rest. `from_start`: it is the
  /// settling of the poured powder, which otherwise lasts until that rests.
  explicit Settle(std::optional<double> duration, bool from_start = false)
      : duration_(duration), from_start_(from_start) {}
  std::optional<double> duration() const override { return duration_; }
  /// Without a duration.
  bool open_ended() const override { return !duration_; }
  bool from_start() const { return from_start_; }
  std::string description() const override;

 private:
  std::optional<double> duration_;
  bool from_start_ = false;
};

/// Reads a step of kind "settle": until at rest, or for the optional `duration`.
std::shared_ptr<Step> read_settle(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
