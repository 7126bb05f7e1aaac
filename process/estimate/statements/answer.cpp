#include "process/estimate/statements/answer.h"

#include <algorithm>

#include "process/estimate/statements/limits.h"
#include "process/estimate/statements/wording.h"
#include "process/estimate/trapped_air.h"
#include "process/results/formatted.h"

namespace diefill::process::estimate {

namespace {

/// Cavities that the shoe may fill.
std::vector<const OpeningEstimate*> cavities_of(const Estimate& estimate) {
  std::vector<const OpeningEstimate*> cavities;
  for (const OpeningEstimate& opening : estimate.openings)
    if (opening.is_cavity && !opening.offered.empty()) cavities.push_back(&opening);
  return cavities;
}

/// Why the numbers settle nothing, whatever they are.
std::vector<std::string> reasons_without_answer(const Estimate& estimate) {
  if (estimate.powder_limited) return {"the shoe holds less powder than the openings take: pour more"};
  std::vector<std::string> reasons;
  for (const OpeningEstimate* cavity : cavities_of(estimate))
    if (const std::string why = too_coarse(estimate, *cavity); !why.empty()) reasons.push_back(why);
  if (!reasons.empty()) return reasons;
  if (const std::string doubts = doubts_of_law(estimate); !doubts.empty()) reasons.push_back(doubts);
  for (const std::string& limit : limits_passed(estimate))
    reasons.push_back("outside the range of the formula, " + limit + ": simulate");
  return reasons;
}

/// Why a cavity may not be full although by the numbers it is.
std::vector<std::string> reasons_against_full(const Estimate& estimate) {
  std::vector<std::string> reasons;
  for (const OpeningEstimate* cavity : cavities_of(estimate))
    if (cavity->air_escapes && cavity->air_ratio >= kAirSlows)
      reasons.push_back(
          results::formatted("air slows the filling, as that of ") + name_of(estimate, *cavity) +
          results::formatted(" needs %.2g of the filling time to escape through powder (from %.1g on it "
                             "slows), which neither the formula nor a run without [suction] has: go slower, "
                             "or let the punch fall under the shoe",
                             cavity->air_ratio, kAirSlows));
  for (const SuctionEstimate& suction : estimate.suctions)
    if (suction.may_arch)
      reasons.push_back("powder may arch over " + suction.punch.tool +
                        ", as the opening is narrow for the grains and nothing shakes the shoe while the "
                        "punch falls: shake it, or simulate");
  for (const std::string& cavity : estimate.unseen)
    reasons.push_back(cavity + " is not seen from above and not estimated: simulate");
  return reasons;
}

}  // namespace

void find_answer(Estimate& estimate) {
  const auto cavities = cavities_of(estimate);
  if (cavities.empty()) {
    estimate.answer = Answer::nothing_moves;
    return;
  }
  estimate.answer = Answer::open;
  estimate.open_because = reasons_without_answer(estimate);
  if (!estimate.open_because.empty()) return;
  const auto least_is_full = [](const auto* cavity) { return cavity->least_share >= kFull; };
  const auto most_is_full = [](const auto* cavity) { return cavity->most_share >= kFull; };
  if (!std::all_of(cavities.begin(), cavities.end(), most_is_full)) {
    estimate.answer = Answer::too_fast;
  } else if (std::all_of(cavities.begin(), cavities.end(), least_is_full)) {
    estimate.open_because = reasons_against_full(estimate);
    if (estimate.open_because.empty()) estimate.answer = Answer::fills;
  }
}

}  // namespace diefill::process::estimate
