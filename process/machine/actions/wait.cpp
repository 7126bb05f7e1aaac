#include "process/machine/actions/wait.h"

#include "process/machine/motion_limits.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kDuration = {Dimension::time, "50 ms", "0 s", motion_limits::kLongest, true};

}  // namespace

std::string Wait::description() const {
  return "a wait of " + number_text(duration_) + " s";
}

std::shared_ptr<Step> read_wait(TableReader& table, const std::vector<ToolSpec>&) {
  return std::make_shared<Wait>(table.required_quantity("duration", kDuration));
}

}  // namespace diefill::process
