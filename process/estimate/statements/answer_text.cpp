#include <algorithm>
#include <numeric>

#include "process/estimate/statements/limits.h"
#include "process/estimate/statements/wording.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::process::estimate {

namespace {

/// Of what the cavity holds, floor or not.
double offered_share(const OpeningEstimate& opening) {
  return std::accumulate(opening.offered.begin(), opening.offered.end(), 0.0) / opening.full_mass;
}

/// What to do where the shoe is too fast, or may be.
std::string remedy(const Estimate& estimate, const OpeningEstimate& opening) {
  if (!(estimate.path.speed > 0)) return "give it more time, or widen the opening";
  std::string text;
  if (opening.speed_once) text = results::formatted("%.2g m/s fills it in one crossing", *opening.speed_once);
  if (opening.crossings && *opening.crossings > static_cast<int>(opening.offered.size()))
    text += (text.empty() ? "" : ", ") +
            results::formatted("%d crossings fill it at %.2g m/s", *opening.crossings, estimate.path.speed);
  if (!text.empty()) return text;
  if (opening.any_speed) return "it fills while the shoe stands over it, at any speed";
  return "not even a hundredth of the speed fills it by this formula: widen the opening";
}

/// "one crossing at 0.2 m/s", and whether that is more than one thing.
struct Subject {
  std::string words;
  bool several;
  std::string does(const char* verb) const { return words + ' ' + verb + (several ? "" : "s"); }
};

Subject subject(const Estimate& estimate, const OpeningEstimate& opening) {
  constexpr double kWorthAWord = 0.01;  // s
  const std::string grains = with_grains(estimate.grain_diameter);
  if (opening.poured >= kWhole) return {"powder poured over it" + grains, false};
  if (!(estimate.path.speed > 0)) return {"the shoe standing over it" + grains, false};
  std::string words = times(opening.offered.size()) + results::formatted(" at %.3g m/s", estimate.path.speed);
  if (estimate.path.standing > kWorthAWord)
    words += results::formatted(" and a dwell of %.2g s", estimate.path.standing);
  return {words + grains, opening.offered.size() > 1};
}

std::string joined(const std::vector<std::string>& clauses) {
  std::string text;
  for (const auto& clause : clauses) text += (text.empty() ? "" : "; ") + clause;
  return text;
}

/// "; outside the range of the formula: ..." and what the fit of its law remarks on, or nothing.
std::string beyond_the_range(const Estimate& estimate) {
  const std::string limits = joined(limits_passed(estimate)), doubts = doubts_of_law(estimate);
  return (limits.empty() ? "" : "; outside the range of the formula: " + limits) +
         (doubts.empty() ? "" : "; " + doubts);
}

/// What a scene without a cavity under the shoe has to tell.
std::string nothing_to_fill(const Estimate& estimate) {
  for (const OpeningEstimate& opening : estimate.openings) {
    if (opening.is_cavity || opening.offered.empty()) continue;
    std::string text = "no cavity to be filled: " + results::mass_text(opening.mass.back()) +
                       " run through " + name_of(estimate, opening) + " in " + times(opening.offered.size());
    if (estimate.path.speed > 0) text += results::formatted(" at %.3g m/s", estimate.path.speed);
    return text + with_grains(estimate.grain_diameter) + ", " + results::mass_text(opening.least_mass) +
           " to " + results::mass_text(opening.most_mass) + " with the uncertainty" +
           (opening.runs_out()        ? "; what is poured over it runs out before it rests"
            : estimate.powder_limited ? "; that is all that the shoe holds"
                                      : "") +
           beyond_the_range(estimate);
  }
  if (estimate.outlet) {
    const std::string cohesion = too_cohesive(estimate);
    return "no shoe passes over an opening: " + outlet_text(estimate) +
           (cohesion.empty() ? "" : "; outside the range of the formula: " + cohesion);
  }
  if (estimate.only_shaken)
    return "no shoe passes over an opening, and there is no formula for powder that is only shaken or "
           "stirred: simulate";
  return "no shoe passes over an opening: there is nothing to estimate here; simulate";
}

/// " cavity 2 about 46 % full, 31 to 69 % with the uncertainty"
std::string share_text(const Estimate& estimate, const OpeningEstimate& opening) {
  return ' ' + name_of(estimate, opening) +
         results::formatted(" about %.0f %% full, %.0f to %.0f %% with the uncertainty",
                            percent_up_to_full(opening.share), percent_up_to_full(opening.least_share),
                            percent_up_to_full(opening.most_share));
}

std::string open_text(const Estimate& estimate, const OpeningEstimate& worst) {
  const Subject passages = subject(estimate, worst);
  const std::string leaves = passages.does("leave") + share_text(estimate, worst);
  if (estimate.open_because.empty())
    return "too close to call: " + leaves +
           ". Simulate, or measure your powder (diefill fit-discharge); by the formula " +
           remedy(estimate, worst);
  if (estimate.powder_limited) return joined(estimate.open_because) + ", then estimate again";
  const bool nothing_runs = !too_coarse(estimate, worst).empty();
  return "open: " + joined(estimate.open_because) + (nothing_runs ? "" : ". By the formula " + leaves);
}

std::string too_fast_text(const Estimate& estimate, const OpeningEstimate& worst) {
  if (!(worst.filling_time > 0))
    return "powder never comes over " + name_of(estimate, worst) +
           ": it stays empty. No simulation is needed for this: lead the shoe over it";
  return (estimate.path.speed > 0 ? "the shoe is too fast: " : "it does not fill: ") +
         subject(estimate, worst).does("leave") + ' ' + name_of(estimate, worst) +
         results::formatted(
             " about %.0f %% full, at most %.0f %% with the uncertainty. No simulation is needed for this: ",
             percent_up_to_full(worst.share), percent_up_to_full(worst.most_share)) +
         remedy(estimate, worst);
}

std::string fills_text(const Estimate& estimate, const OpeningEstimate& worst) {
  return subject(estimate, worst).does("fill") +
         " every cavity: " + results::in_significant_digits(offered_share(worst), 2) + " times what " +
         name_of(estimate, worst) +
         results::formatted(
             " holds would run in, and it is at least %.0f %% full with the uncertainty. No simulation is "
             "needed for this; simulate for the density map",
             percent_up_to_full(worst.least_share)) +
         (estimate.powder.carrying_flux
              ? ""
              : ". Air is left out: give the size of the real particles with --particle-diameter");
}

}  // namespace

std::string answer_text(const Estimate& estimate) {
  if (!estimate.is_estimated())
    return (estimate.answer == Answer::shut ? "nothing runs in: " : "no estimate: ") +
           joined(estimate.open_because);
  const OpeningEstimate* worst = emptiest(estimate);
  if (worst == nullptr) return nothing_to_fill(estimate);
  switch (estimate.answer) {
    case Answer::too_fast:
      return too_fast_text(estimate, *worst);
    case Answer::fills:
      return fills_text(estimate, *worst);
    case Answer::nothing_moves:
    case Answer::open:
    case Answer::no_formula:
    case Answer::shut:
      break;
  }
  return open_text(estimate, *worst);
}

std::vector<std::string> in_short(const Estimate& estimate) {
  std::vector<std::string> lines = {"estimate without simulation: " + answer_text(estimate)};
  const std::string error = ". Its error: " + error_text(estimate) + ". diefill estimate says more";
  if (estimate.answer == Answer::fills)
    lines.push_back("the estimate alone shows that every cavity fills" + error);
  if (estimate.answer == Answer::too_fast)
    lines.push_back("the estimate alone shows that " + name_of(estimate, *emptiest(estimate)) +
                    " does not fill" + error);
  if (estimate.is_estimated() && !estimate.powder.left_out.empty()) lines.push_back(powders_text(estimate));
  return lines;
}

}  // namespace diefill::process::estimate
