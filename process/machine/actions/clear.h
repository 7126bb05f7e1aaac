// Removes powder: all outside the die, because powder left in the shoe and on the plate costs time and has no
// effect any more; or all above a height; or all but the lowest part, which cuts a bed flat.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// What stays: powder in the cavity and up to `heap` m above its fill plane, or where `above` is given, all
/// grains with their centres up to this height (m), or where `lowest` is given, this share of all grains.
struct PowderRemoval {
  double heap = 0;
  std::optional<double> above, lowest;
};

class Clear final : public Step {
 public:
  explicit Clear(const PowderRemoval& removal) : removal_(removal) {}
  std::optional<double> duration() const override { return 0; }
  const PowderRemoval* removal() const override { return &removal_; }
  std::string description() const override;

 private:
  PowderRemoval removal_;
};

/// Reads a step of kind "clear".
std::shared_ptr<Step> read_clear(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
