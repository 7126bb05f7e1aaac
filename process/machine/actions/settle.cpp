#include "process/machine/actions/settle.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kDuration = {Dimension::time, "0.2 s", "0 s", "1000 s", true};

}  // namespace

std::string Settle::description() const {
  return duration_ ? "settling for " + number_text(*duration_) + " s" : "settling until at rest";
}

std::shared_ptr<Step> read_settle(TableReader& table, const std::vector<ToolSpec>&) {
  return std::make_shared<Settle>(table.quantity("duration", kDuration));
}

}  // namespace diefill::process
