#include "process/machine/actions/settle.h"

#include "process/machine/motion_limits.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kDuration = {Dimension::time, "0.2 s", "0 s", motion_limits::kLongest, true};

}  // namespace

std::string Settle::description() const {
  return duration_ ? "settling for " + number_text(*duration_) + " s" : "settling until at rest";
}

std::shared_ptr<Step> read_settle(TableReader& table, const std::vector<ToolSpec>&) {
  const auto duration = table.quantity("duration", kDuration);
  return std::make_shared<Settle>(duration, table.flag("from_start").value_or(false));
}

}  // namespace diefill::process
