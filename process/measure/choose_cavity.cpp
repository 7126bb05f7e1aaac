#include "process/measure/choose_cavity.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/enough_grains.h"
#include "process/measure/measure.h"

namespace diefill::process {

void choose_cavity(results::FillResult& result, int number) {
  const int last = static_cast<int>(result.other_cavities.size()) + 1;
  if (number == 1) return;
  if (number < 1 || number > last)
    throw std::invalid_argument("found " + std::to_string(number) + "; the tools have " +
                                (last == 1 ? "one cavity" : "cavities 1 to " + std::to_string(last)));
  std::swap(result.cavity, result.other_cavities[static_cast<std::size_t>(number) - 2]);
  result.solid_fraction.in_cavity = grains_in_cavity(result.cavity, result.powder);
  result.summary = reliable_summary(summarise(result.powder, result.solid_fraction, result.cavity));
  for (std::string* words : {&result.title, &result.strategy})
    if (!words->empty()) *words += ", cavity " + std::to_string(number);
}

}  // namespace diefill::process
