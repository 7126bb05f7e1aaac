#include "process/machine/actions/clear.h"

#include "process/input/units.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kHeap = {Dimension::length, "1 mm", "0 mm", "1 m"};
constexpr NumberRule kLowest = {0, 0.999, true, "0.8"};
constexpr QuantityRule kAbove = {Dimension::length, "20 mm", "-10 m", "10 m"};

}  // namespace

std::string Clear::description() const {
  if (removal_.above) return "removal of powder above " + number_text(1e3 * *removal_.above) + " mm";
  if (removal_.lowest)
    return "removal of powder but for the lowest " + number_text(100 * *removal_.lowest) + " % of the grains";
  return "removal of powder outside the die";
}

std::shared_ptr<Step> read_clear(TableReader& table, const std::vector<ToolSpec>&) {
  PowderRemoval removal;
  removal.heap = table.quantity("heap", kHeap).value_or(removal.heap);
  removal.above = table.quantity("above", kAbove);
  removal.lowest = table.number("lowest", kLowest);
  if (removal.above && table.has("heap"))
    table.reject("heap", "above is given as well; remove one of the two");
  if (removal.lowest && (removal.above || table.has("heap")))
    table.reject("lowest", "heap or above is given as well; remove one of the two");
  return std::make_shared<Clear>(removal);
}

}  // namespace diefill::process
