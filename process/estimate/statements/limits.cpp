#include "process/estimate/statements/limits.h"

#include "process/estimate/statements/wording.h"
#include "process/results/formatted.h"

namespace diefill::process::estimate {

namespace {

constexpr double kSlack = 1.003;  // widths are sampled

void add_limits(const Estimate& estimate, const OpeningEstimate& opening, std::vector<std::string>& passed) {
  const double grain = estimate.grain_diameter;
  const std::string name = name_of(estimate, opening);
  const std::string grains = results::formatted("grains of %.3g mm are ", 1e3 * grain);
  if (grain > kCoarsestGrain * kSlack * opening.width)
    passed.push_back(grains + results::formatted("%.2f of the width of ", grain / opening.width) + name +
                     results::formatted(", at most %.2f", kCoarsestGrain));
  else if (opening.narrowest > 0 && grain > kCoarsestGrain * kSlack * opening.narrowest)
    passed.push_back(grains +
                     results::formatted("%.2f of the %.3g mm to which ", grain / opening.narrowest,
                                        1e3 * opening.narrowest) +
                     name + results::formatted(" narrows, at most %.2f", kCoarsestGrain));
  if (opening.froude > kLargestFroude && opening.poured < kWhole)
    passed.push_back(results::formatted("the shoe passes at %.2g sqrt(g D) over ", opening.froude) + name +
                     results::formatted(", at most %.2g", kLargestFroude));
  if (!estimate.law.holds_beyond_longest && opening.longest_x > kSlack * estimate.law.longest)
    passed.push_back(
        "powder flows into " + name +
        results::formatted(" for up to %.3g sqrt(D/g), and ", opening.longest_x + continuum::kBurst) +
        estimate.law.source +
        results::formatted(" does not show how it flows after %.3g",
                           estimate.law.longest + continuum::kBurst));
}

}  // namespace

std::string too_coarse(const Estimate& estimate, const OpeningEstimate& opening) {
  const std::string grains =
      results::formatted("grains of %.3g mm are too coarse for ", 1e3 * estimate.grain_diameter) +
      name_of(estimate, opening);
  if (!(opening.effective_width > 0))
    return grains +
           results::formatted(
               ", %.3g mm wide: 1.4 d of an opening stay empty, so that nothing runs in; take finer grains",
               1e3 * opening.width);
  const double excess = opening.width - opening.effective_width;
  if (opening.narrowest > 0 && opening.narrowest <= excess)
    return grains + results::formatted(
                        ", which narrows to %.3g mm: 1.4 d of a width stay empty, so that nothing comes down "
                        "there; take finer grains",
                        1e3 * opening.narrowest);
  return {};
}

std::string too_cohesive(const Estimate& estimate) {
  if (estimate.bond <= kSlack * estimate.law.largest_bond) return {};
  return results::formatted(
             "the powder's Bond number, adhesion over weight, is %.3g, and its law was compared with flows "
             "up to "
             "%.3g (",
             estimate.bond, estimate.law.largest_bond) +
         estimate.law.of_bond + "), beyond which less runs in, or powder arches";
}

std::string doubts_of_law(const Estimate& estimate) {
  std::string text;
  for (const std::string& doubt : estimate.law.doubts)
    text += (text.empty() ? estimate.law.source + " says: " : "; ") + doubt;
  return text;
}

std::vector<std::string> limits_passed(const Estimate& estimate) {
  std::vector<std::string> passed;
  if (estimate.powder.depth * kSlack < kShallowestPowder)
    passed.push_back(results::formatted("powder is %.3g mm deep in the shoe, at least %.3g mm",
                                        1e3 * estimate.powder.depth, 1e3 * kShallowestPowder));
  if (const std::string cohesion = too_cohesive(estimate); !cohesion.empty()) passed.push_back(cohesion);
  for (const auto& opening : estimate.openings)
    if (!opening.offered.empty()) add_limits(estimate, opening, passed);
  return passed;
}

}  // namespace diefill::process::estimate
