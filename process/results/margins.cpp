#include "process/results/margins.h"

#include <algorithm>
#include <cmath>

#include "process/results/figure_table.h"
#include "process/results/rounding.h"

namespace diefill::results {
namespace {

constexpr const char* kEnergy = "energy_balance_error";

std::string percent_in_two_digits(double share) {
  return in_significant_digits(100 * share, 2) + " %";
}

}  // namespace

double Margin::share() const {
  return std::max(0.0, either_side ? std::abs(found) / limit : found / limit);
}

std::vector<Margin> margins(const FillResult& result) {
  const auto value = [&](const char* name) { return figure_of(result, name); };
  const auto margin = [&](const char* name, double limit, bool either_side = false) {
    return Margin{title_of(figure_called(name)), value(name), limit, either_side};
  };
  std::vector<Margin> all = {margin("time_step_fraction", 1),
                             margin("deepest_overlap_ratio", value("overlap_limit_ratio")),
                             margin("deepest_wall_overlap_ratio", value("wall_overlap_limit_ratio")),
                             // Energy gained and energy lost are the same error of integration.
                             margin(kEnergy, value("energy_error_limit"), true)};
  std::erase_if(all, [](const Margin& found) { return !std::isfinite(found.found); });
  return all;
}

std::vector<std::string> exceeded_text(const FillResult& result) {
  std::vector<std::string> lines;
  for (const Margin& margin : margins(result)) {
    if (!margin.exceeded()) continue;
    if (margin.name == title_of(figure_called(kEnergy)))
      lines.push_back("energy balance: " + percent_in_two_digits(std::abs(margin.found)) +
                      " of the energy exchanged was " + (margin.found < 0 ? "lost" : "gained") +
                      " without explanation, above the limit of +-" + percent_in_two_digits(margin.limit) +
                      ": do not rely on this run; use a shorter time step "
                      "(numerics.time_step_fraction) and compare");
    else
      lines.push_back(margin.name + " reached " + in_significant_digits(margin.found, 3) +
                      ", above the limit of " + in_significant_digits(margin.limit, 3) +
                      ": do not rely on this run; use a shorter time step "
                      "(numerics.time_step_fraction) and compare");
  }
  return lines;
}

}  // namespace diefill::results
