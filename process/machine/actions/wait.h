// The machine stands still for a given time, whether the powder rests or not.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

class Wait final : public Step {
 public:
  /// `duration` in s.
  explicit Wait(double duration) : duration_(duration) {}
  std::optional<double> duration() const override { return duration_; }
  std::string description() const override;

 private:
  double duration_;
};

/// Reads a step of kind "wait" with its `duration`.
std::shared_ptr<Step> read_wait(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
