#include "process/run/figures/margin_warnings.h"

#include <cstdio>

#include "engine/limits/validity_monitor.h"
#include "process/results/margins.h"

namespace diefill::process {

std::vector<std::string> margin_warnings(const results::FillResult& result) {
  auto lines = results::exceeded_text(result);
  const engine::ValidityLimits limits;
  const auto error = result.figures.find("energy_balance_error");
  if (error == result.figures.end()) return lines;
  const double lost = -error->second;
  if (lost > limits.warning_energy_error && lost <= limits.energy_error) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "energy balance: %.1f %% of the energy exchanged was lost without explanation; up to "
                  "+-%.1f %% is acceptable",
                  100 * lost, 100 * limits.warning_energy_error);
    lines.emplace_back(text);
  }
  return lines;
}

}  // namespace diefill::process
