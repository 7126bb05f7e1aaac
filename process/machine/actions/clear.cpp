#include "process/machine/actions/clear.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kHeap = {Dimension::length, "1 mm", "0 mm", "1 m"};

}  // namespace

std::shared_ptr<Step> read_clear(TableReader& table, const std::vector<ToolSpec>&) {
  PowderRemoval removal;
  removal.heap = table.quantity("heap", kHeap).value_or(removal.heap);
  return std::make_shared<Clear>(removal);
}

}  // namespace diefill::process
